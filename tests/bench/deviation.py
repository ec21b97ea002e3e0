#!/usr/bin/env python3
"""deviation.py WHOLE.gcode SIMPLE.gcode: prints the distance between the beads of two files.

Both files are of one print, with gcode_resolution = 0 and with another value. The script compares paths: runs of
extruding moves between moves that do not extrude. It prints the greatest distance in mm from any corner or midpoint of
a move of either file to the path of the other file. It also prints the greatest relative difference in a path's
filament, over the paths with at least 0.1 mm of filament.
"""
import collections
import math
import re
import sys

WORD = re.compile(r"([A-Z])(-?[0-9.]+)")
CELL = 1.0  # cell size in mm


def paths_of(name):
    """Returns the runs of extruding moves as (points, total filament)."""
    at, points, filament, paths = (0.0, 0.0), [], 0.0, []
    with open(name, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if not line.startswith("G1 "):
                continue
            words = dict(WORD.findall(line.split(";")[0])[1:])
            to = (float(words.get("X", at[0])), float(words.get("Y", at[1])))
            pushed = float(words.get("E", 0))
            if pushed > 0 and to != at:
                if not points:
                    points, filament = [at], 0.0
                points.append(to)
                filament += pushed
            elif points:
                paths.append((points, filament))
                points = []
            at = to
    return paths + ([(points, filament)] if points else [])


def from_segment(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    squared = dx * dx + dy * dy
    t = ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / squared if squared else 0
    t = min(1.0, max(0.0, t))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def cells(a, b):
    """Returns the cells near a segment."""
    steps = max(1, math.ceil(math.dist(a, b) / CELL * 2))
    return {(math.floor((a[0] + (b[0] - a[0]) * i / steps) / CELL) + x,
             math.floor((a[1] + (b[1] - a[1]) * i / steps) / CELL) + y)
            for i in range(steps + 1) for x in (-1, 0, 1) for y in (-1, 0, 1)}


def farthest(chain, other):
    """Returns the greatest distance from a corner or midpoint of a chain to another chain. A distance beyond one cell
    is reported as one cell.
    """
    grid = collections.defaultdict(list)
    for a, b in zip(other, other[1:]):
        for cell in cells(a, b):
            grid[cell].append((a, b))
    worst = 0.0
    for p in chain + [((a[0] + b[0]) / 2, (a[1] + b[1]) / 2) for a, b in zip(chain, chain[1:])]:
        near = grid.get((math.floor(p[0] / CELL), math.floor(p[1] / CELL)), [])
        worst = max(worst, min((from_segment(p, a, b) for a, b in near), default=CELL))
    return worst


def main():
    whole, simple = paths_of(sys.argv[1]), paths_of(sys.argv[2])
    if len(whole) != len(simple):
        sys.exit(f"{len(whole)} and {len(simple)} paths")
    place = filament = 0.0
    for w, s in zip(whole, simple):
        place = max(place, farthest(w[0], s[0]), farthest(s[0], w[0]))
        if w[1] > 0.1:
            filament = max(filament, abs(s[1] / w[1] - 1))
    moves = [sum(len(p[0]) - 1 for p in paths) for paths in (whole, simple)]
    print(f"paths {len(whole)}\nmoves {moves[0]} {moves[1]}\ndeviation_mm {place:.5f}\nfilament_share {filament:.6f}")


if __name__ == "__main__":
    main()
