#!/usr/bin/env python3
"""Writes the box of tests/bench/infill.sh and measures the infill of its G-code.

usage: infill_box.py box [SIDE HEIGHT]   an STL to stdout
       infill_box.py measure OUT.gcode   one row: got paths longest_mm travels travel_mm moves
"""
import math
import re
import sys

SIDE, HEIGHT, WALL = 80.0, 16.0, 0.45
FILAMENT_MM2 = math.pi * 1.75**2 / 4


def print_box(side, height):
    corners = [(x, y, z) for z in (0, height) for y in (0, side) for x in (0, side)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    print("solid box")
    for a, b, c, d in quads:
        for triangle in ((a, b, c), (a, c, d)):
            print("facet normal 0 0 0\nouter loop")
            for i in triangle:
                print("vertex %g %g %g" % corners[i])
            print("endloop\nendfacet")
    print("endsolid box")


def measure(path):
    """Prints the row of a G-code file. A path is a run of infill without a travel or a change of feature or height."""
    x = y = z = e = 0.0
    relative = False
    feature = ""
    volume = longest = run = travel_mm = 0.0
    paths = travels = moves = 0
    travelling = False
    word = re.compile(r"([XYZEF])([-+0-9.]+)")
    for line in open(path, encoding="utf-8", errors="replace"):
        if line.startswith(";TYPE:"):
            feature = line[6:].strip()
            longest, run = max(longest, run), 0.0
        if line.startswith(("M82", "M83")):
            relative = line.startswith("M83")
        values = {k: float(v) for k, v in word.findall(line.split(";")[0])}
        if line.startswith("G92"):
            e = values.get("E", e)
        if not line.startswith(("G0 ", "G1 ")):
            continue
        to_x, to_y, to_z = values.get("X", x), values.get("Y", y), values.get("Z", z)
        push = values["E"] - (0 if relative else e) if "E" in values else 0.0
        e = values.get("E", e)
        length = math.hypot(to_x - x, to_y - y)
        if length > 1e-9 and push > 1e-9:
            moves += 1
            travelling = False
            if feature == "Internal infill":
                paths += run == 0
                run += length
                volume += push * FILAMENT_MM2
        elif length > 1e-9:
            travels += not travelling
            travelling = True
            travel_mm += length
            longest, run = max(longest, run), 0.0
        if to_z != z:
            longest, run = max(longest, run), 0.0
        x, y, z = to_x, to_y, to_z
    longest = max(longest, run)
    got = 100 * volume / ((SIDE - 2 * WALL) ** 2 * HEIGHT)
    print(f"{got:.2f} {paths} {longest:.0f} {travels} {travel_mm:.0f} {moves}")


if __name__ == "__main__":
    if sys.argv[1:] == ["box"]:
        print_box(SIDE, HEIGHT)
    elif len(sys.argv) == 4 and sys.argv[1] == "box":
        print_box(float(sys.argv[2]), float(sys.argv[3]))
    elif len(sys.argv) == 3 and sys.argv[1] == "measure":
        measure(sys.argv[2])
    else:
        sys.exit(__doc__)
