# SPDX-License-Identifier: BSD-3-Clause
"""One page of HTML that needs no other file."""

import html
import pathlib

from pkm_workspace.core import __version__

STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #1b1f24; max-width: 72rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.8rem; margin: 0 0 .3rem; } h2 { margin: 2.2rem 0 .5rem; border-bottom: 1px solid #c9d1d9; }
p { max-width: 48rem; } .note { color: #57606a; }
.scroll { overflow-x: auto; } table { border-collapse: collapse; margin: .6rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .3rem .8rem .3rem 0; text-align: left; vertical-align: top; border-bottom: 1px solid #e3e7eb; }
thead th { border-bottom: 2px solid #57606a; } table.sortable th { cursor: pointer; }
table.sortable th::after { content: " \\2195"; color: #8c959f; } th[data-order=up]::after { content: " \\2191"; }
th[data-order=down]::after { content: " \\2193"; } table.sortable td { white-space: nowrap; } td.number { text-align: right; padding-right: 1.2rem; }
figure { margin: 1rem 0; overflow-x: auto; } figure.wide svg { min-width: 52rem; } figure svg { max-width: 100%; height: auto; } figcaption { color: #57606a; max-width: 48rem; }
@media print { body { max-width: none; padding: 0; font-size: 11px; } figure.wide svg { min-width: 0; } h2, figure, tr { break-inside: avoid; } }
"""
SORT = """
for (const table of document.querySelectorAll("table.sortable"))
  table.querySelectorAll("th").forEach((head, column) => head.addEventListener("click", () => {
    const up = head.dataset.order !== "up", body = table.tBodies[0];
    table.querySelectorAll("th").forEach(other => delete other.dataset.order);
    head.dataset.order = up ? "up" : "down";
    const key = row => row.cells[column].dataset.value ?? row.cells[column].textContent;
    const both = (a, b) => isNaN(a) || isNaN(b) ? String(a).localeCompare(String(b)) : a - b;
    const empty = row => key(row) === "";
    [...body.rows].sort((a, b) => empty(a) - empty(b) || (up ? 1 : -1) * both(key(a), key(b)))
      .forEach(row => body.append(row));
  }));
"""


class Page:
    def __init__(self, title, subtitle=""):
        self.title = title
        self.parts = [f"<h1>{html.escape(title)}</h1>", f'<p class="note">{html.escape(subtitle)}</p>']

    def section(self, heading):
        self.parts.append(f"<h2>{html.escape(heading)}</h2>")

    def text(self, *sentences, note=False):
        self.parts.append(f"<p{' class=note' * note}>{html.escape(' '.join(sentences))}</p>")

    def figure(self, svg, caption, is_wide=False):
        self.parts.append(f"<figure{' class=wide' * is_wide}>{svg}<figcaption>{html.escape(caption)}</figcaption></figure>")

    def table(self, heads, rows, sortable=False):
        """Cells are text, or (text, number to sort by)."""
        head = "".join(f"<th>{html.escape(name)}</th>" for name in heads)
        body = "".join(f"<tr>{''.join(map(cell, row))}</tr>" for row in rows)
        self.parts.append(f'<div class="scroll"><table{" class=sortable" * sortable}><thead><tr>{head}</tr></thead>'
                          f"<tbody>{body}</tbody></table></div>")

    def save(self, path):
        text = (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>{html.escape(self.title)}</title>'
                f'<meta name="viewport" content="width=device-width, initial-scale=1"><style>{STYLE}</style></head>'
                f"<body>{''.join(self.parts)}<p class=note>pkm_workspace {html.escape(__version__)}</p>"
                f"<script>{SORT}</script></body></html>\n")
        pathlib.Path(path).write_text(text, encoding="utf-8")


def cell(value):
    if isinstance(value, tuple):
        text, key = value
        return f'<td class="number" data-value="{"" if key is None else repr(key)}">{html.escape(text)}</td>'
    return f"<td>{html.escape(str(value))}</td>"
