#!/usr/bin/env python3
"""moves.py OUT.gcode [PEER.gcode]: prints the number of moves per metre of each feature, and the bytes of a file by
kind of line.

The counts are of extruding moves in the plane (G1, G2, G3), by the names of `;TYPE:` in PrusaSlicer: metres, moves per
metre, share of moves shorter than 0.1 mm. `walls` are all perimeters without gap fill.
"""
import collections
import math
import re
import sys

WORD = re.compile(r"([A-Z])(-?[0-9.]+)")
SHORT_MM = 0.1
WALLS = ("Perimeter", "External perimeter", "Overhang perimeter")


def arc_length(start, end, offset, clockwise):
    """Returns the length of a G2 or G3 from start to end around start + offset; all in mm."""
    centre = (start[0] + offset[0], start[1] + offset[1])
    a = math.atan2(start[1] - centre[1], start[0] - centre[0])
    b = math.atan2(end[1] - centre[1], end[0] - centre[0])
    turn = (a - b if clockwise else b - a) % (2 * math.pi)
    return (turn or 2 * math.pi) * math.hypot(*offset)


class Counts:
    """Counts of moves and bytes in one file."""

    def __init__(self, path):
        self.length = collections.Counter()  # length in mm by feature
        self.moves = collections.Counter()
        self.short = collections.Counter()
        self.bytes = collections.Counter()
        self.at = {"X": 0.0, "Y": 0.0, "E": 0.0}
        self.absolute = True  # E values are absolute
        self.feature = ""
        with open(path, encoding="utf-8", errors="replace") as lines:
            for line in lines:
                self.bytes["all"] += len(line)
                self.bytes[self.read(line)] += len(line)

    def read(self, line):
        """Counts a line and returns its kind."""
        if line.startswith(";"):
            if line.startswith(";TYPE:"):
                self.feature = line[6:].strip()
            return line.split(":")[0][:8] if line.startswith((";WIDTH", ";HEIGHT", ";TYPE")) else "other comments"
        code = line.split(None, 1)[0] if line.strip() else ""
        if code in ("M82", "M83"):
            self.absolute = code == "M82"
        words = {key: float(value) for key, value in WORD.findall(line.split(";")[0])[1:]}
        if code == "G92":
            self.at.update({key: value for key, value in words.items() if key in self.at})
        if code not in ("G0", "G1", "G2", "G3"):
            return "other"
        return self.move(code, words)

    def move(self, code, words):
        pushed = 0.0
        if "E" in words:
            pushed = words["E"] - self.at["E"] if self.absolute else words["E"]
            self.at["E"] = words["E"]
        to = {key: words.get(key, self.at[key]) for key in "XY"}
        start, end = (self.at["X"], self.at["Y"]), (to["X"], to["Y"])
        if code in ("G2", "G3"):
            length = arc_length(start, end, (words.get("I", 0), words.get("J", 0)), code == "G2")
        else:
            length = math.dist(start, end)
        self.at.update(to)
        if pushed <= 0 or length == 0:
            return "travel" if length > 0 else "other moves"
        self.length[self.feature] += length
        self.moves[self.feature] += 1
        self.short[self.feature] += length < SHORT_MM
        return "beads"

    def row(self, features):
        """Returns metres, moves per metre and the share of short moves of some features together."""
        length = sum(self.length[f] for f in features) / 1000
        moves = sum(self.moves[f] for f in features)
        short = sum(self.short[f] for f in features)
        return length, moves / length if length else 0, short / moves if moves else 0


def main():
    counts = [Counts(path) for path in sys.argv[1:3]]
    features = sorted(set().union(*(c.moves for c in counts)))
    groups = [(f, [f]) for f in features] + [("walls", WALLS), ("all", features)]
    print("feature\t" + "\t".join(["m", "moves/m", "short"] * len(counts)) + "\tratio" * (len(counts) > 1))
    for name, members in groups:
        rows = [c.row(members) for c in counts]
        line = "\t".join(f"{r[0]:.2f}\t{r[1]:.0f}\t{r[2]:.3f}" for r in rows)
        ratio = f"\t{rows[0][1] / rows[1][1]:.2f}" if len(rows) > 1 and rows[1][1] else ""
        print(f"{name}\t{line}{ratio}")
    kinds = sorted(set().union(*(c.bytes for c in counts)), key=lambda k: -counts[0].bytes[k])
    for kind in kinds:
        line = "\t".join(str(c.bytes[kind]) for c in counts)
        ratio = f"\t{counts[0].bytes[kind] / counts[1].bytes[kind]:.2f}" if len(counts) > 1 and counts[1].bytes[kind] else ""
        print(f"bytes of {kind}\t{line}{ratio}")


if __name__ == "__main__":
    main()
