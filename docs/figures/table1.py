"""Draws docs/src/img/blast-table1.svg: crater radius over charge, from the rows of docs/src/verification.csv.

    cargo xtask verify-all scenes/blast/long/table1.toml scenes/blast/long/table1_literal.toml
    python3 docs/figures/table1.py
"""

import csv
import math
import re
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "src"

# Tian & Li, table 1: charge in kg, radius in m.
PAPER = {0.512: 0.75, 1: 1.0, 1.728: 1.1, 3.375: 1.4, 8: 2.1, 27: 2.9, 64: 3.9}

WIDTH, HEIGHT = 640, 420
LEFT, RIGHT, TOP, BOTTOM = 70, 430, 40, 360
CHARGES, RADII = (0.4, 80), (0.3, 6)


def measured(scene):
    """Radius (m) over charge (kg) in the rows of a scene."""
    name = re.compile(r"crater radius, ([\d.]+) kg")
    found = {}
    with (DOCS / "verification.csv").open(newline="") as rows:
        for row in csv.DictReader(rows):
            charge = name.match(row["check"])
            if charge and row["scene"] == f"scenes/blast/long/{scene}.toml" and row["unit"] == "m":
                found[float(charge[1])] = float(row["measured"])
    if len(found) != len(PAPER):
        raise SystemExit(f"verification.csv has {len(found)} of the {len(PAPER)} radii of {scene}: run it with `cargo xtask verify-all`")
    return found


def power_law(points):
    """a, b and the standard error of b in r = a Q^b, least squares of the logarithms."""
    x, y = ([math.log(v) for v in side] for side in zip(*sorted(points.items())))
    n, mean_x, mean_y = len(x), sum(x) / len(x), sum(y) / len(y)
    spread = sum((u - mean_x) ** 2 for u in x)
    slope = sum((u - mean_x) * (v - mean_y) for u, v in zip(x, y)) / spread
    start = mean_y - slope * mean_x
    misfit = sum((v - start - slope * u) ** 2 for u, v in zip(x, y))
    return math.exp(start), slope, math.sqrt(misfit / (n - 2) / spread)


def place(value, limits, low, high):
    """Where a value lies on a logarithmic axis."""
    share = (math.log10(value) - math.log10(limits[0])) / (math.log10(limits[1]) - math.log10(limits[0]))
    return low + share * (high - low)


def across(charge):
    return place(charge, CHARGES, LEFT, RIGHT)


def up(radius):
    return place(radius, RADII, BOTTOM, TOP)


def main():
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}"'
        ' font-family="DejaVu Sans, sans-serif" font-size="12" fill="#1a1a1a">',
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        f'<text x="{LEFT}" y="24" font-size="14">Table 1: crater radius over charge</text>',
    ]
    for q in (0.5, 1, 2, 5, 10, 20, 50):
        x = across(q)
        out.append(f'<line x1="{x:.1f}" x2="{x:.1f}" y1="{TOP}" y2="{BOTTOM}" stroke="#e6e6e6"/>')
        out.append(f'<text x="{x:.1f}" y="{BOTTOM + 18}" text-anchor="middle">{q:g}</text>')
    for r in (0.3, 0.5, 1, 2, 3, 5):
        y = up(r)
        out.append(f'<line x1="{LEFT}" x2="{RIGHT}" y1="{y:.1f}" y2="{y:.1f}" stroke="#e6e6e6"/>')
        out.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{r:g}</text>')
    middle = (TOP + BOTTOM) / 2
    out += [
        f'<rect x="{LEFT}" y="{TOP}" width="{RIGHT - LEFT}" height="{BOTTOM - TOP}" fill="none" stroke="#1a1a1a"/>',
        f'<text x="{(LEFT + RIGHT) / 2}" y="{BOTTOM + 42}" text-anchor="middle">charge [kg]</text>',
        f'<text transform="translate(24 {middle}) rotate(-90)" text-anchor="middle">crater radius [m]</text>',
    ]
    series = [
        ("paper", PAPER, "#1a1a1a", "#1a1a1a"),
        ("matched", measured("table1"), "#0072b2", "#0072b2"),
        ("literal", measured("table1_literal"), "#d55e00", "none"),
    ]
    y = 60
    for name, points, stroke, fill in series:
        ring = f'r="4" fill="{fill}" stroke="{stroke}" stroke-width="1.5"'
        out += [f'<circle cx="{across(q):.1f}" cy="{up(r):.1f}" {ring}/>' for q, r in sorted(points.items())]
        out.append(f'<circle cx="{RIGHT + 18}" cy="{y - 4}" {ring}/><text x="{RIGHT + 30}" y="{y}">{name}</text>')
        a, b, error = power_law(points)
        # The literal radii scatter too much for a line.
        if name != "literal":
            ends = [(across(q), up(a * q**b)) for q in (0.45, 72)]
            out.append('<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}"'.format(*ends[0], *ends[1]) + f' stroke="{stroke}" stroke-dasharray="6 4"/>')
        out.append(f'<text x="{RIGHT + 30}" y="{y + 18}" font-size="11">{a:.3f} Q^{b:.3f} (± {error:.3f})</text>')
        y += 44
    out.append("</svg>")
    (DOCS / "img" / "blast-table1.svg").write_text("\n".join(out) + "\n")


if __name__ == "__main__":
    main()
