# SPDX-License-Identifier: BSD-3-Clause
"""Plots as SVG in a page. Colours are those that people tell apart whatever colours they see (Okabe and Ito, 2008)."""

import io

import numpy as np

from pkm_workspace.errors import PkmError

BLUE, ORANGE, GREEN, PURPLE, GREY = "#0072b2", "#d55e00", "#009e73", "#cc79a7", "#8c959f"


def plain(text):
    """Without what matplotlib takes for mathematics."""
    return str(text).replace("$", r"\$")


def pyplot():
    try:
        import matplotlib
    except ImportError:
        raise PkmError("reports need matplotlib (Debian: python3-matplotlib)") from None
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    plt.rcParams.update({"svg.hashsalt": "pkm_workspace", "svg.fonttype": "none", "font.size": 10,
                         "axes.spines.top": False, "axes.spines.right": False})
    return plt


def svg(figure):
    """Without date, so that the same numbers give the same file."""
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches="tight", metadata={"Date": None})
    pyplot().close(figure)
    return text.getvalue()[text.getvalue().index("<svg"):]


def bars(names, lowers, uppers, label):
    """Brackets as bars up to what is proved, and lines to the upper bounds."""
    figure, axes = pyplot().subplots(figsize=(7, 0.6 + 0.4 * len(names)))
    places = np.arange(len(names))[::-1]
    axes.barh(places, lowers, color=BLUE, height=0.6)
    axes.hlines(places, lowers, uppers, color=ORANGE, linewidth=3)
    axes.set_yticks(places, list(map(plain, names)))
    axes.set_xlabel(label)
    return svg(figure)


def ranges(rows, label):
    """@param rows: (name, (lower, upper) that is taken, (lower, upper) that there is, or None)"""
    figure, axes = pyplot().subplots(figsize=(7, 0.6 + 0.5 * len(rows)))
    for place, (_, taken, limits) in zip(range(len(rows) - 1, -1, -1), rows):
        if limits:
            axes.hlines(place, *limits, color=GREY, linewidth=3)
        axes.hlines(place, *taken, color=BLUE, linewidth=9)
    axes.set_yticks(range(len(rows) - 1, -1, -1), [plain(name) for name, *_ in rows])
    axes.set_ylim(-0.6, len(rows) - 0.4)
    axes.set_xlabel(label)
    return svg(figure)


def sections(planes, levels, label):
    """Fields over planes, side by side, with lines at levels.

    @param planes: (name of one axis, its values, name of the other, its values, field, outline to draw over it)
    """
    figure, row = pyplot().subplots(1, len(planes), figsize=(4.2 * len(planes), 3.8), constrained_layout=True)
    fields = [np.ma.masked_invalid(field) for *_, field, _ in planes]
    top = max((float(field.max()) for field in fields if field.count()), default=1.0)
    for axes, (across, xs, up, ys, _, outline), field in zip(np.atleast_1d(row), planes, fields):
        image = axes.pcolormesh(xs, ys, field.T, cmap="cividis", vmin=0.0, vmax=top, shading="nearest", rasterized=True)
        within = [level for level in levels if field.count() and field.min() < level < field.max()]
        if within:
            axes.contour(xs, ys, field.filled(np.nan).T, levels=within, colors=ORANGE, linewidths=1.5)
        if outline is not None:
            axes.plot(*outline, color="white", linewidth=2)
        axes.set_aspect("equal")
        axes.set_xlabel(f"{across} [m]")
        axes.set_ylabel(f"{up} [m]")
    figure.colorbar(image, ax=row, label=label, shrink=0.8)
    return svg(figure)


def scatter(xs, lowers, uppers, x_label, y_label, marked=None):
    """Brackets over a parameter. @param marked: numbers of points that are joined by a line"""
    figure, axes = pyplot().subplots(figsize=(6, 3.6))
    axes.vlines(xs, lowers, uppers, color=ORANGE, linewidth=1)
    axes.plot(xs, lowers, ".", color=BLUE, markersize=4)
    if marked is not None and len(marked):
        axes.plot(np.asarray(xs)[marked], np.asarray(lowers)[marked], "o-", color=GREEN, markersize=5)
    axes.set_xlabel(plain(x_label))
    axes.set_ylabel(y_label)
    return svg(figure)


def signed_bars(names, values, label):
    figure, axes = pyplot().subplots(figsize=(6, 0.6 + 0.4 * len(names)))
    places = np.arange(len(names))[::-1]
    axes.barh(places, values, color=[BLUE if value >= 0 else ORANGE for value in values], height=0.6)
    axes.axvline(0.0, color=GREY, linewidth=1)
    axes.set_yticks(places, list(map(plain, names)))
    axes.set_xlim(-1, 1)
    axes.set_xlabel(label)
    return svg(figure)
