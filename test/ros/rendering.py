# SPDX-License-Identifier: BSD-3-Clause
"""rviz on a screen that only exists in memory: what it shows, as an array of colours, and which of them are where."""

import os
import pathlib
import re
import signal
import struct
import subprocess
import tempfile
import time
import zlib

import numpy

PATIENCE = 120.0  # [s] until what was expected has not come; software draws a picture in about one
STARTS = 4  # of one launch file, where rviz dies
SIZE = (1280, 900)
BACKGROUND = (250, 250, 250)


def near(color, distance=10):
    return lambda r, g, b: numpy.maximum.reduce([abs(r - color[0]), abs(g - color[1]), abs(b - color[2])]) <= distance


# What has a colour of its own, lit from any side and seen through what is transparent.
COLORS = {
    "region's faces": lambda r, g, b: (b > r + 35) & (g > r + 20) & (b < g + 60) & (r > 60),
    "region's edges": near((13, 64, 153), 14),
    "joint ranges": lambda r, g, b: (r > 170) & (r - b > 120) & (g > 0.4 * r) & (g < 0.62 * r),
    "set": lambda r, g, b: (g - r >= 6) & (g - b >= 4) & (r > 100) & (g > 140),
    "border of the set": lambda r, g, b: (r - b >= 12) & (r >= g) & (g > b + 4) & (r > 190),
    "end by psi_min": lambda r, g, b: (r - g >= 15) & (g - b >= 15) & (r > 170),
    "end by psi_max": lambda r, g, b: (r - g >= 12) & (b - g >= 5) & (r > 150),
    "labels": lambda r, g, b: (r == g) & (g == b) & (r > 20) & (r < 45),
    "rails": lambda r, g, b: (b - r > 5) & (b - r < 15) & (g >= r) & (b >= g) & (r > 40) & (r < 135),
    "sliders": lambda r, g, b: (b > 120) & (b < 185) & (r < 0.4 * b) & (g > 0.45 * b) & (g < 0.6 * b),
    "struts": lambda r, g, b: (r > 120) & (r - b > 80) & (g > 0.64 * r) & (g < 0.76 * r),
    "table": lambda r, g, b: (r - b > 7) & (r - b < 18) & (r >= g) & (g >= b) & (r > 150) & (r < 190),
    "green": lambda r, g, b: (g - r > 50) & (g - b > 45),
    "red": lambda r, g, b: (r - g > 100) & (r - b > 90) & (abs(g - b) < 45),
    "green box": lambda r, g, b: (g - r > 25) & (g - r < 55) & (b >= r) & (g - b > 15) & (r > 110),
    "red box": lambda r, g, b: (r - g > 25) & (abs(g - b) < 16) & (g > 90),
    "blue arrows": lambda r, g, b: (b - r > 80) & (abs(r - g) < 20),
    "drawn": lambda r, g, b: (r != g) | (g != b) | (r < 200),
}


def pieces(mask, least=1, cell=12):
    """Parts of a mask that are about two cells apart from each other: one array of places (row, column) for each."""
    places = numpy.argwhere(mask)
    cells = {}
    for place, at in zip(places, map(tuple, places // cell)):
        cells.setdefault(at, []).append(place)
    found = []
    while cells:
        border, piece = [next(iter(cells))], []
        while border:
            row, column = border.pop()
            piece += cells.pop((row, column), [])
            border += [at for at in ((row + i, column + k) for i in (-1, 0, 1) for k in (-1, 0, 1)) if at in cells]
        if len(piece) >= least:
            found.append(numpy.array(piece))
    return found


def longest_run(flags):
    """The slice of the longest part where all are true."""
    ends = numpy.flatnonzero(numpy.diff(numpy.concatenate(([0], flags.astype(numpy.int8), [0]))))
    runs = ends.reshape(-1, 2)
    return slice(*runs[numpy.argmax(runs[:, 1] - runs[:, 0])]) if len(runs) else slice(0, 1)


class Picture:
    """What is on the screen: rviz's three-dimensional view, and on its left the list of displays."""

    def __init__(self, pixels):
        self.pixels = pixels
        background = near(BACKGROUND, 0)(*self.channels(pixels))
        columns = longest_run(background.mean(0) > 0.05)
        rows = longest_run(background[:, columns].mean(1) > 0.05)
        self.view = pixels[rows, columns]
        self.corner = numpy.array([rows.start, columns.start])  # of the view
        self.list = pixels[:, :columns.start]

    @staticmethod
    def channels(pixels):
        return numpy.moveaxis(pixels.astype(numpy.int16), 2, 0)

    def mask(self, name):
        return COLORS[name](*self.channels(self.view))

    def percent(self, name):
        """How much of the view has this colour."""
        return 100.0 * self.mask(name).mean()

    def count(self, name, least, cell):
        """How many pieces, of so many pixels at least, have this colour."""
        return len(pieces(self.mask(name), least, cell))

    def lean(self, name, least):
        """How far pieces lean to the left on average, going upwards [degrees]."""
        leans = [0.0]
        for piece in pieces(self.mask(name), least):
            rows, columns = piece.T
            leans.append(numpy.degrees(numpy.arctan(numpy.polyfit(rows, columns, 1)[0])))
        return sum(leans) / max(1, len(leans) - 1)

    def margin(self):
        """From what is drawn to the view's border, the least on any side [percent of the view's height]."""
        places = numpy.argwhere(self.mask("drawn"))
        if not len(places):
            return 0.0
        size = numpy.array(self.view.shape[:2])
        return 100.0 * min(*places.min(0), *(size - 1 - places.max(0))) / size[0]

    def middle(self, name):
        """Of what has this colour: row and column on the screen."""
        places = numpy.argwhere(self.mask(name))
        return self.corner + numpy.median(places, 0).astype(int)

    def height(self):
        """Of what is drawn [percent of the view's height]."""
        rows = numpy.flatnonzero(self.mask("drawn").any(1))
        return 100.0 * (rows[-1] - rows[0]) / self.view.shape[0] if len(rows) else 0.0

    def listed(self, color):
        """How many pixels of the list of displays are written in this colour."""
        return int(near(color, 0)(*self.channels(self.list)).sum())


def png(pixels):
    """The bytes of a PNG file."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    height, width, _ = pixels.shape
    rows = b"".join(b"\0" + row.tobytes() for row in pixels)
    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b"")


class Screen:
    """An X server of its own, on a display that is free, which keeps what is shown in a file of the format XWD."""

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory()
        reading, writing = os.pipe()
        command = ["Xvfb", "-displayfd", str(writing), "-screen", "0", "{}x{}x24".format(*SIZE),
                   "-fbdir", self.folder.name, "-nolisten", "tcp", "-nocursor"]
        self.server = subprocess.Popen(command, pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            number = answer.readline().strip()
        if not number:
            raise RuntimeError("Xvfb did not start")
        self.environment = {**os.environ, "DISPLAY": f":{number}", "LIBGL_ALWAYS_SOFTWARE": "1",
                            "QT_QPA_PLATFORM": "xcb", "HOME": self.folder.name}
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait(PATIENCE)
        self.folder.cleanup()

    def click(self, row, column, button=1):
        subprocess.run(["xdotool", "mousemove", str(column), str(row), "sleep", "0.3", "mousemove_relative", "1", "0",
                        "sleep", "0.3", "click", str(button)], env=self.environment, check=True)

    def picture(self):
        data = (pathlib.Path(self.folder.name) / "Xvfb_screen0").read_bytes()
        header = struct.unpack(">25I", data[:100])
        size, width, height, line, colors = header[0], header[4], header[5], header[12], header[19]
        rows = numpy.frombuffer(data, numpy.uint8, line * height, size + 12 * colors).reshape(height, line)
        return Picture(rows[:, :4 * width].reshape(height, width, 4)[:, :, 2::-1].copy())


class Launch(Screen):
    """A launch file of this package, as it is shipped, on a screen of its own; ends with all that it started."""

    def __init__(self, machine, **arguments):
        options = [f"{name}:={value}" for name, value in arguments.items()]
        self.command = ["roslaunch", "pkm_workspace", f"{machine}.launch", *options]
        self.starts = 0

    def __enter__(self):
        super().__enter__()
        self.log = pathlib.Path(self.folder.name) / "roslaunch.log"
        self.start()
        return self

    def __exit__(self, *_):
        self.stop()
        super().__exit__()

    def start(self):
        self.starts += 1
        with self.log.open("w") as log:
            self.process = subprocess.Popen(self.command, env=self.environment, stdout=log, stderr=subprocess.STDOUT)

    def stop(self):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(PATIENCE)

    def restart_after_a_crash(self):
        """Where processors are busy, rviz on software GL dies now and then while it opens (one time in about fifty),
        its heap spoilt, though no code of this package runs in it. Whoever sits before it would start it again."""
        if self.starts < STARTS and re.search(r"\[rviz-\d+\] process has died", self.log.read_text()):
            self.stop()
            self.start()

    def wait_for(self, expectations, name):
        """Waits for one picture in which each of {text: (function of it, least, most)} holds. Returns it."""
        deadline = time.monotonic() + PATIENCE
        while True:
            picture = self.picture()
            values = {text: function(picture) for text, (function, _, _) in expectations.items()}
            wrong = [f"{text}: {values[text]:.4g}, expected {least} to {most}"
                     for text, (_, least, most) in expectations.items() if not least <= values[text] <= most]
            if not wrong:
                return picture
            if time.monotonic() > deadline:
                path = pathlib.Path(tempfile.gettempdir()) / f"pkm_workspace_view_{name}.png"
                path.write_bytes(png(picture.pixels))
                heading = f"{name} was not seen as expected; picture in {path}; {' '.join(self.command)} said:"
                raise AssertionError("\n".join([heading, self.log.read_text(), *wrong]))
            self.restart_after_a_crash()
