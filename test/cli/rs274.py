# SPDX-License-Identifier: BSD-3-Clause
"""G-code as the NIST definition has it (Kramer, Proctor, Messina: The NIST RS274NGC Interpreter, version 3, 2000): an
interpretation in fractions that shares nothing with the one of pkm. Arcs are sampled by their angles."""

import math
import re
from fractions import Fraction

WORD = re.compile(r"([A-Z])\s*([-+]?(?:\d+\.?\d*|\.\d+))")
PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}  # first and second axis of the plane, and its normal
INCH = Fraction(254, 10000)


class Move:
    """Along a line or a helix, or where the place is known again: the point at a share of the way [m], and the speed
    [m/s], None of rapid moves."""

    def __init__(self, line, start, end, arc=None):
        self.line, self.start, self.end, self.arc = line, start, end, arc
        self.speed = None
        self.is_point = False
        if arc:
            first, second, self.normal = arc["plane"]
            self.axes = (first, second)
            self.center = arc["center"]
            angle = lambda point: math.atan2(point[second] - self.center[second], point[first] - self.center[first])
            self.radius = math.hypot(start[first] - self.center[first], start[second] - self.center[second])
            self.begin = angle(start)
            sense = arc["sense"]
            turn = sense * (angle(end) - self.begin) % (2 * math.pi)
            if all(start[k] == end[k] for k in self.axes):
                turn = 2 * math.pi
            self.turn = sense * (turn + 2 * math.pi * (arc["turns"] - 1))

    def point(self, t):
        point = [float(a + (b - a) * Fraction(t)) for a, b in zip(self.start, self.end)]
        if self.arc:
            angle = self.begin + t * self.turn
            point[self.axes[0]] = self.center[self.axes[0]] + self.radius * math.cos(angle)
            point[self.axes[1]] = self.center[self.axes[1]] + self.radius * math.sin(angle)
        return [float(x) for x in point]

    def length(self):
        if not self.arc:
            return math.dist(self.point(0), self.point(1))
        return math.hypot(self.radius * self.turn, float(self.end[self.normal] - self.start[self.normal]))


class Interpreter:
    """Moves in the root frame; those from an unknown place are counted, and are points where they end the doubt."""

    def __init__(self, origin=(0, 0, 0), offsets=None, lengths=None, programmed_rapids=False):
        self.origin = [Fraction(str(x)) for x in origin]
        self.systems = {code: [Fraction(0)] * 3 for code in range(540, 594)}
        for name, offset in (offsets or {}).items():
            self.systems[name] = [Fraction(str(x)) for x in offset]
        self.lengths = {number: Fraction(str(x)) for number, x in (lengths or {}).items()}
        self.programmed_rapids = programmed_rapids
        self.place, self.shift, self.tool, self.system = [None] * 3, [Fraction(0)] * 3, Fraction(0), 540
        self.unit, self.absolute, self.absolute_arcs, self.inverse = Fraction(1, 1000), True, False, False
        self.plane, self.motion, self.feed, self.unknown = 17, None, None, 0

    def zero(self, axis):
        return self.systems[self.system][axis] + self.shift[axis] + (self.tool if axis == 2 else 0)

    def run(self, lines):
        for number, line in enumerate(lines, 1):
            move = self.step(number, re.sub(r"\(.*?\)|;.*", "", line).upper())
            if move:
                yield move

    def step(self, number, text):
        if re.match(r"\s*(M1\d\d|M8[234])\b", text):
            if re.match(r"\s*M84", text):
                self.place = [None] * 3
            return None
        words = WORD.findall(text)
        codes = [int(10 * Fraction(value)) for letter, value in words if letter == "G"]
        word = {letter: Fraction(value) for letter, value in words if letter not in "GM"}
        if ("M", "6") in words or 280 in codes:
            self.place = [None] * 3
            self.unknown += 280 in codes
            return None
        self.set_modes(codes, word)
        if 100 in codes:
            for axis, letter in enumerate("XYZ"):
                if letter in word:
                    self.systems[530 + 10 * int(word["P"])][axis] = word[letter] * self.unit
        elif 920 in codes:
            for axis, letter in enumerate("XYZ"):
                if letter in word:
                    self.shift[axis] += self.place[axis] - self.zero(axis) - word[letter] * self.unit
        elif set("XYZIJKR") & set(word):
            return self.move(number, word, 530 in codes)
        return None

    def set_modes(self, codes, word):
        for code in codes:
            if code in (930, 940):
                self.inverse = code == 930
            elif code in (200, 210):
                self.unit = INCH if code == 200 else Fraction(1, 1000)
            elif code in (170, 180, 190):
                self.plane = code // 10
            elif 540 <= code <= 593:
                self.system = code
            elif code in (900, 910):
                self.absolute = code == 900
            elif code in (901, 911):
                self.absolute_arcs = code == 901
            elif code in (430, 490):
                self.tool = self.lengths[int(word["H"])] if code == 430 else Fraction(0)
            elif code == 921:
                self.shift = [Fraction(0)] * 3
            elif code in (0, 10, 20, 30):
                self.motion = code // 10
        if "F" in word:
            self.feed = word["F"] if self.inverse else word["F"] * self.unit

    def move(self, number, word, in_machine):
        start, end = self.place, list(self.place)
        for axis, letter in enumerate("XYZ"):
            if letter not in word:
                continue
            value = word[letter] * self.unit
            if in_machine:
                end[axis] = value
            elif self.absolute:
                end[axis] = value + self.zero(axis)
            elif end[axis] is not None:
                end[axis] += value
        self.place = end
        in_root = lambda place: [a + b for a, b in zip(place, self.origin)]
        if None in start:
            self.unknown += 1
            point = None if None in end else Move(number, in_root(end), in_root(end))
            if point:
                point.is_point = True
            return point
        if self.motion < 2 and start == end:
            return None
        move = Move(number, in_root(start), in_root(end), self.arc(word, in_root(start), in_root(end)))
        if self.motion > 0 or self.programmed_rapids:
            move.speed = float(self.feed) / 60 * (move.length() if self.inverse else 1)
        return move

    def arc(self, word, start, end):
        if self.motion < 2:
            return None
        first, second, _ = PLANES[self.plane]
        sense = 1 if self.motion == 3 else -1
        center = [float(x) for x in start]
        if "R" in word:
            radius = float(word["R"] * self.unit)
            x, y = float(end[first] - start[first]), float(end[second] - start[second])
            chord = math.hypot(x, y)
            aside = math.sqrt(radius * radius - chord * chord / 4) / chord * sense * (1 if radius > 0 else -1)
            center[first] += x / 2 - aside * y
            center[second] += y / 2 + aside * x
        for axis, letter in enumerate("IJK"):
            if letter in word:
                from_zero = self.zero(axis) + self.origin[axis] if self.absolute_arcs else start[axis]
                center[axis] = float(word[letter] * self.unit + from_zero)
        return {"plane": PLANES[self.plane], "center": center, "sense": sense, "turns": int(word.get("P", 1))}
