# SPDX-License-Identifier: BSD-3-Clause
"""The text of docs/paper.md, for scripts/figures."""

INTRODUCTION = """\
# The paper's figures and ours

What the paper prints, what is proved here (brackets: a region of the lower figure exists, none above the upper
one), and whether the paper's figure holds within one unit of its last digit. Everything on this page, figures
included, is made by

```sh
scripts/figures    # needs python3-matplotlib
rosrun pkm_workspace pkm compare --paper --accuracy 1e-4    # the table alone
```

"""

AFTER_THE_TABLE = """
Joint limits are off, as in the paper. Strokes, volumes and ratios are those of our largest regions. Table 2 fails
where regions larger by a few millimetres exist: the paper's edges are multiples of 0.01 m, each less than 0.01 m
below ours, so its accuracy there was 0.01 m. The Orthoglide's strokes contain singular points outside its cube,
against the paper's sentence.

## The two workspaces

What each machine reaches in its own aspect with the strokes of its largest cube (equalised: each begins at the
least value of its own joint and has the largest length of the three), and the cube in it; one eighth is cut away.
Every box drawn is proved to be within reach; where the cube's sides show, only the layer of boxes at the border,
undecided at 0.04 m, is left out.

![Orthoglide](figures/orthoglide_workspace.png)
![UraneSX](figures/uranesx_workspace.png)

## The UraneSX over its plane

Least and largest velocity transmission factor (floating point), where their bounds lie (red), and the largest
square in white (proved).

![psi_min and psi_max over the plane of the UraneSX](figures/uranesx_psi.png)

## The square over lambda

![Edge of the square over lambda](figures/uranesx_edge_over_lambda.png)

## Which UraneSX is the best?

"""


def table(rows):
    lines = ["| place | what | paper | ours | the paper's |", "|---|---|---|---|---|"]
    for row in rows:
        verdict = {True: "holds", False: "**fails**", None: "-"}[row["holds"]]
        lines.append(f"| {row['place']} | {row['what'].strip()} | {row['paper']} | {row['ours']} | {verdict} |")
    return "\n".join(lines) + "\n"


def best_uranesx(study, rows):
    """The paper's claim about R < 7/13 against a machine and a proof."""
    lower = min(part["lower"] for part in study["candidates"])
    upper = max(part["upper"] for part in study["candidates"])
    smaller = next(row for row in rows if row["paper"] == "not satisfied")
    radius = study["parameter"] + 3 / 26
    return f"""\
The paper says that no UraneSX with R < 7/13 m satisfies the bounds. Machines that do are easy to name: lambda =
-0.035 m has a square of {smaller['ours']} m, larger than any in the paper's table. Regions depend on R - r only, so
the question is which R - r is best. Proved (`pkm study`, for all R - r from {study['range'][0]} m to
{study['range'][1]} m, L = 1 m):

- R - r = {study['parameter']:.10f} m (with r = 3/26 m: R = {radius:.6f} m, below 7/13 m = 0.538462 m) has a
  dextrous square of edge {study['size'] - 5e-7:.6f} m;
- no machine of the range has one of more than {study['size_upper_bound'] + 5e-7:.6f} m;
- only machines with R - r from {lower - 5e-8:.7f} m to {upper + 5e-8:.7f} m may have one larger than that of
  this machine.

The optimum is at R - r = 2 / (3 sqrt 3) m = 0.3849002 m, where the size jumps: below it, a spot within the square,
midway between two rails, leaves psi_min = 0.5. The figure shows the proved bracket of the largest edge in each part
of the range; how it is found is in [study.md](study.md).

![Edge of the square over R - r](figures/uranesx_edge_over_radius.png)
"""


def paper_text(rows, study):
    return INTRODUCTION + table(rows) + AFTER_THE_TABLE + best_uranesx(study, rows)
