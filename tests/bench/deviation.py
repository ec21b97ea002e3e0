#!/usr/bin/env python3
"""deviation.py WHOLE.gcode SIMPLE.gcode: how far the beads of one file lie from those of another, path by path.

Both are of one print, made without and with simplification (gcode_resolution). A path is a run of extruding moves
between two that do not extrude. Prints the greatest distance in mm from any corner or middle of a move of either file to
the path of the other one, the greatest difference of width along the way (width = what ;WIDTH: would say, from the
extruded volume), and the greatest share by which a path's filament differs.
"""
import math
import re
import sys

import numpy as np

WORD = re.compile(r"([A-Z])(-?[0-9.]+)")


def paths_of(name):
    """Runs of extruding moves: (array of points, array of filament a move)."""
    at = [0.0, 0.0]
    points, pushed, paths = [], [], []

    def end():
        if pushed:
            paths.append((np.array(points), np.array(pushed)))

    with open(name, encoding="utf-8", errors="replace") as lines:
        for line in lines:
            if not line.startswith(("G1 ", "G0 ", "G2 ", "G3 ")):
                continue
            words = dict(WORD.findall(line.split(";")[0])[1:])
            to = [float(words.get("X", at[0])), float(words.get("Y", at[1]))]
            filament = float(words.get("E", 0))
            if filament > 0 and to != at:
                if not pushed:
                    points = [at]
                points.append(to)
                pushed.append(filament)
            else:
                end()
                points, pushed = [], []
            at = to
    end()
    return paths


def distance(points, chain):
    """From each point to a chain of points; mm."""
    a, b = chain[:-1], chain[1:]
    step = b - a
    squared = np.maximum((step**2).sum(axis=1), 1e-18)
    t = ((points[:, None, :] - a) * step).sum(axis=2) / squared
    near = a + np.clip(t, 0, 1)[:, :, None] * step
    return np.sqrt(((points[:, None, :] - near) ** 2).sum(axis=2).min(axis=1))


def places(chain):
    return np.concatenate([chain, (chain[1:] + chain[:-1]) / 2])


def flow_error(whole, simple):
    """Greatest difference of filament a mm, where a move of the simple path stands for moves of the whole one."""
    corner = {tuple(p): i for i, p in enumerate(map(tuple, whole[0]))}
    lengths = np.hypot(*(whole[0][1:] - whole[0][:-1]).T)
    worst, begin = 0.0, 0
    for i in range(len(simple[1])):
        end = next((k for k in range(begin + 1, len(whole[0])) if tuple(whole[0][k]) == tuple(simple[0][i + 1])), None)
        if end is None:
            return float("nan")
        rate = simple[1][i] / math.dist(simple[0][i], simple[0][i + 1])
        long = lengths[begin:end] > 0.05  # E has steps of 1e-5 mm
        if long.any():
            worst = max(worst, np.abs(whole[1][begin:end][long] / lengths[begin:end][long] - rate).max())
        begin = end
    return worst


def main():
    whole, simple = paths_of(sys.argv[1]), paths_of(sys.argv[2])
    if len(whole) != len(simple):
        sys.exit(f"{len(whole)} and {len(simple)} paths")
    there = back = filament = width = 0.0
    height, section = float(sys.argv[3]) if len(sys.argv) > 3 else 0.2, math.pi * 1.75**2 / 4
    for w, s in zip(whole, simple):
        there = max(there, distance(places(w[0]), s[0]).max())
        back = max(back, distance(places(s[0]), w[0]).max())
        if w[1].sum() > 0.01:
            filament = max(filament, abs(s[1].sum() / w[1].sum() - 1))
        width = np.nanmax([width, flow_error(w, s) * section / height])
    print(f"paths {len(whole)}\nmoves {sum(len(p[1]) for p in whole)} {sum(len(p[1]) for p in simple)}")
    print(f"deviation_mm {max(there, back):.5f}\nwidth_mm {width:.4f}\nfilament_share {filament:.6f}")


if __name__ == "__main__":
    main()
