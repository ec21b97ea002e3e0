#!/usr/bin/env python3
"""Counts the changes in the number of beads across a wall between layers in which the wall itself does not change.

    flicker.py OUT.gcode...

Probes every layer along lines 1 mm apart, in x and in y. A crossing is a run of touching beads on a probe line, less
than 3 mm long. It is the same crossing in the next layer if both its ends moved by less than 0.06 mm. Prints for each
file: crossings compared, changes, changes per mm of height and crossing.
"""
import collections
import sys

PITCH = 1.0
LONGEST = 3.0
MOVED = 0.06
TOUCH = 0.12
BEADS = ("External perimeter", "Perimeter", "Overhang perimeter", "Gap fill", "Thin wall")


def layers_of(path):
    """Yields (z, [(x0, y0, x1, y1, width)]) for each layer."""
    segments, z, x, y, kind, width = [], 0.0, 0.0, 0.0, "", 0.45
    for line in open(path, errors="replace"):
        if line.startswith(";Z:"):
            if segments:
                yield z, segments
            z, segments = float(line[3:]), []
        elif line.startswith(";TYPE:"):
            kind = line[6:].strip()
        elif line.startswith(";WIDTH:"):
            width = float(line[7:])
        elif line.startswith("G1 "):
            words = {w[0]: float(w[1:]) for w in line.split(";")[0].split()[1:] if len(w) > 1}
            nx, ny = words.get("X", x), words.get("Y", y)
            if words.get("E", 0) > 0 and (nx, ny) != (x, y) and kind in BEADS:
                segments.append((x, y, nx, ny, width))
            x, y = nx, ny
    if segments:
        yield z, segments


def places(segments, swap):
    """Returns the sorted crossings (start, end, number of beads) of each probe line."""
    crossings = collections.defaultdict(list)
    for x0, y0, x1, y1, width in segments:
        if swap:
            x0, y0, x1, y1 = y0, x0, y1, x1
        low, high = min(y0, y1), max(y0, y1)
        probe = int(low // PITCH) + 1
        length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
        while probe * PITCH <= high:
            slant = abs(y1 - y0) / length
            if slant > 0.7 and (probe * PITCH > low or low == y0):
                at = x0 + (x1 - x0) * (probe * PITCH - y0) / (y1 - y0)
                half = width / 2 / slant
                crossings[probe].append((at - half, at + half))
            probe += 1
    found = {}
    for probe, beads in crossings.items():
        beads.sort()
        stretches = []
        for start, end in beads:
            if stretches and start <= stretches[-1][1] + TOUCH:
                last = stretches[-1]
                stretches[-1] = (last[0], max(last[1], end), last[2] + 1)
            else:
                stretches.append((start, end, 1))
        found[probe] = [s for s in stretches if s[1] - s[0] < LONGEST]
    return found


def compare(before, after):
    compared = changes = 0
    for probe, stretches in after.items():
        for start, end, beads in stretches:
            for other in before.get(probe, []):
                if abs(other[0] - start) < MOVED and abs(other[1] - end) < MOVED:
                    compared += 1
                    changes += other[2] != beads
    return compared, changes


def main():
    for path in sys.argv[1:]:
        compared = changes = 0
        height = 0.0
        last = None
        for z, segments in layers_of(path):
            now = [places(segments, swap) for swap in (False, True)]
            if last:
                for a, b in zip(last[1], now):
                    c, d = compare(a, b)
                    compared, changes, height = compared + c, changes + d, height + c * (z - last[0])
            last = (z, now)
        rate = changes / height if height else 0.0
        print(f"{path} places {compared} changes {changes} per_mm {rate:.4f}")


if __name__ == "__main__":
    main()
