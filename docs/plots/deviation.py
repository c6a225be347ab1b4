#!/usr/bin/env python3
"""Draws docs/plots/deviation.svg from what interpolate_deviation prints.

usage: build/dev/tests/bench/interpolate_deviation | docs/plots/deviation.py \
         > docs/plots/deviation.svg
"""

import csv
import math
import sys

WIDTH, HEIGHT = 760, 420
LEFT, RIGHT, TOP, BOTTOM = 60, 190, 30, 50
COLOURS = ["#1b5e8c", "#7a7a7a", "#c0392b", "#27823b", "#8e44ad", "#b8860b",
           "#16817a", "#d35400", "#2c3e50", "#c2185b", "#5d7a00"]
TOP_VALUE = 3.5


def main():
    series = {}
    for row in csv.DictReader(sys.stdin):
        name = f"{row['method']} ({row['what']})"
        series.setdefault(name, []).append(
            (int(row["extent"]), float(row["worst"])))
    extents = sorted({e for points in series.values() for e, _ in points})
    low, high = math.log2(extents[0]), math.log2(extents[-1])

    def x(extent):
        share = (math.log2(extent) - low) / (high - low)
        return LEFT + share * (WIDTH - LEFT - RIGHT)

    def y(value):
        return HEIGHT - BOTTOM - value / TOP_VALUE * (HEIGHT - TOP - BOTTOM)

    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" '
           f'height="{HEIGHT}" font-family="sans-serif" font-size="11">',
           f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           f'<text x="{LEFT}" y="18">Worst distance from the true line or '
           'circle, grid units</text>']
    for tick in (0, 0.5, 1, 1.5, 2, 2.5, 3, 3.5):
        out.append(f'<path d="M{LEFT} {y(tick):.1f}H{WIDTH - RIGHT}" '
                   'stroke="#ddd"/>')
        out.append(f'<text x="{LEFT - 30}" y="{y(tick) + 4:.1f}">{tick}</text>')
    for extent in extents:
        out.append(f'<text x="{x(extent):.1f}" y="{HEIGHT - BOTTOM + 18}" '
                   f'text-anchor="middle">{extent}</text>')
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 12}" '
               'text-anchor="middle">extent of the curves, units</text>')
    for i, (name, points) in enumerate(series.items()):
        colour = COLOURS[i % len(COLOURS)]
        dash = ' stroke-dasharray="5 3"' if name.endswith("(arc)") else ""
        line = " ".join(f"{x(e):.1f},{y(v):.1f}" for e, v in points)
        out.append(f'<polyline points="{line}" fill="none" '
                   f'stroke="{colour}" stroke-width="1.6"{dash}/>')
        row = TOP + 10 + 18 * i
        out.append(f'<path d="M{WIDTH - RIGHT + 12} {row - 4}h22" '
                   f'stroke="{colour}" stroke-width="1.6"{dash}/>')
        out.append(f'<text x="{WIDTH - RIGHT + 40}" y="{row}">{name}</text>')
    out.append("</svg>")
    print("\n".join(out))


if __name__ == "__main__":
    main()
