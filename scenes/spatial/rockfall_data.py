"""Writes rockfall_slope.asc and prints the rocks of rockfall.toml.

The slope: a rock face above a talus with a gully, a bench and a ditch behind a dam, heights in m on a grid of 2 m, x (down the
slope) from 0 to 90 m, y (across) from -34 to 34 m:

    z = 45 - 12 S((x - 8)/6) - 16 L((x - 14)/22) - 11 L((x - 40)/22) - L((x - 62)/10)           63, 36, 27 and 6 degrees on the mean
      + 5 max(0, 1 - |x - 78|/8)                                                                dam, 32 degrees
      + 2.5 (1 - exp(-(y/10)^2)) S((x - 10)/15) (1 - S((x - 50)/16))                            gully along y = 0
      + S(x/14) (0.25 sin(2 pi x/7.3 + 1.3 sin(2 pi y/11)) sin(2 pi y/8.9 + 0.7) + 0.15 sin(2 pi (x + 0.7 y)/4.7))     roughness
    L(t) = t within 0 and 1, S(t) = L^2 (3 - 2 L)

The rocks: ten hulls of ten points on ellipsoids with half axes of 0.8 to 1.2 m, from a seeded generator of Python.
"""

from math import cos, exp, pi, sin, sqrt
from pathlib import Path
from random import Random


def ramp(t):
    return min(max(t, 0.0), 1.0)


def smooth(t):
    return ramp(t) ** 2 * (3 - 2 * ramp(t))


def height(x, y):
    z = 45 - 12 * smooth((x - 8) / 6) - 16 * ramp((x - 14) / 22) - 11 * ramp((x - 40) / 22) - ramp((x - 62) / 10)
    z += 5 * max(0.0, 1 - abs(x - 78) / 8)
    z += 2.5 * (1 - exp(-((y / 10) ** 2))) * smooth((x - 10) / 15) * (1 - smooth((x - 50) / 16))
    rough = 0.25 * sin(2 * pi * x / 7.3 + 1.3 * sin(2 * pi * y / 11)) * sin(2 * pi * y / 8.9 + 0.7)
    rough += 0.15 * sin(2 * pi * (x + 0.7 * y) / 4.7)
    return z + smooth(x / 14) * rough


def write_slope():
    cell, wide, long = 2, 46, 35
    rows = [f"ncols {wide}", f"nrows {long}", "xllcenter 0", "yllcenter -34", f"cellsize {cell}", "nodata_value -9999"]
    for j in reversed(range(long)):  # the first row is the northernmost
        rows.append(" ".join(f"{height(cell * i, cell * j - 34):.2f}" for i in range(wide)))
    Path(__file__).with_name("rockfall_slope.asc").write_text("\n".join(rows) + "\n")


def print_rocks():
    random = Random(20)
    for k in range(10):
        axes = [random.uniform(0.8, 1.2) for _ in range(3)]
        centre = [13, -13.5 + 3 * k, 39]
        print(f'[[blocks]]\nname = "rock{k + 1}"\ngroups = ["rocks"]\nmaterial = "rock"\npolyhedron.vertices = [')
        for _ in range(10):
            up, turn = random.uniform(-1, 1), random.uniform(0, 2 * pi)
            flat = sqrt(1 - up * up)
            on_ball = [flat * cos(turn), flat * sin(turn), up]
            x, y, z = (c + a * u for c, a, u in zip(centre, axes, on_ball))
            print(f'  ["{x:.2f} m", "{y:.2f} m", "{z:.2f} m"],')
        spin = ", ".join(f'"{random.uniform(-1, 1):.2f} rad/s"' for _ in range(3))
        print("]\ncopies = { count = 4, step = [\"-1 m\", \"0 m\", \"3.2 m\"] }")
        print(f'velocity = ["1.5 m/s", "0 m/s", "0 m/s"]\nspin = [{spin}]\n')


if __name__ == "__main__":
    write_slope()
    print_rocks()
