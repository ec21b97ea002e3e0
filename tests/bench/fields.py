#!/usr/bin/env python3
"""Measures locally if infill follows a density field or a stress field. The part is a box of 80 x 80 x 16 mm with one
wall and no skins; its G-code is compared with the formula from which the field was sampled.

usage: tests/bench/fields.py [PATTERN...] [--dither=blue_noise|floyd_steinberg]

Density rows: `field pattern mean_error bias paths cpu_s`. Cells are 5 mm wide and at least 5 mm inside the box.
mean_error: mean of |got / wanted - 1| over the cells (%). bias: got / wanted - 1 of all cells together (%).
Stress rows: `field family pitch angle_rms even got cpu_s`. Family 0 is the layers along the principal stress of greater
magnitude; family 1 is the layers along the other principal stress. angle_rms: root mean square over the length of the
angle to the field, in degrees, 5 mm inside the box and away from degenerate points. even: share of the length whose
neighbours on both sides are at 0.8 to 1.2 of the wanted pitch. got: density got / wanted.
"""
import json
import math
import os
import pathlib
import re
import resource
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SIDE, HEIGHT, CELL, INSET = 80.0, 16.0, 5.0, 5.0
FILAMENT_MM2 = math.pi * 1.75**2 / 4

DENSITY = {
    "constant": lambda x, y, z: 0.2,
    "across": lambda x, y, z: 0.1 + 0.4 * x / SIDE,
    "aslant": lambda x, y, z: 0.1 + 0.2 * (x + y) / SIDE,
    "bump": lambda x, y, z: 0.1 + 0.4 * max(0, 1 - ((x - 40) ** 2 + (y - 40) ** 2) / 900),
    "waves": lambda x, y, z: 0.25 + 0.1 * math.sin(x / 8) * math.cos(y / 8),
    "height": lambda x, y, z: 0.1 + 0.3 * z / HEIGHT,
    "space": lambda x, y, z: 0.15 + 0.15 * x / SIDE + 0.15 * z / HEIGHT,
    "surface": lambda x, y, z: 0.5 - 0.4 * min(1, max(0, min(x, y, z, SIDE - x, SIDE - y, HEIGHT - z)) / 6),
}


def around(x, y):
    return -(y - 40), x - 40


def kirsch(x, y):
    """Returns the stress (xx, yy, xy), by Kirsch's solution, of a plate under tension along x with a hole of radius 10
    mm in its middle.
    """
    x, y = x - 40, y - 40
    r, t = max(math.hypot(x, y), 10), math.atan2(y, x)
    q = (10 / r) ** 2
    rr = 0.5 * (1 - q) + 0.5 * (1 - 4 * q + 3 * q * q) * math.cos(2 * t)
    tt = 0.5 * (1 + q) - 0.5 * (1 + 3 * q * q) * math.cos(2 * t)
    rt = -0.5 * (1 + 2 * q - 3 * q * q) * math.sin(2 * t)
    c, s = math.cos(t), math.sin(t)
    xx = rr * c * c + tt * s * s - 2 * rt * s * c
    yy = rr * s * s + tt * c * c + 2 * rt * s * c
    return xx, yy, (rr - tt) * s * c + rt * (c * c - s * s)


def beam(x, y):
    """Returns the stress (xx, yy, xy) of a beam that is fixed at x = 0 and loaded at its other end: tension above the
    middle, compression below, the greatest shear in the middle.
    """
    up = y - 40
    return (80 - x) * up, 0, -(40**2 - up * up) / 2


def along(u, v):
    n = max(1e-9, math.hypot(u, v))
    return u * u / n / n, v * v / n / n, u * v / n / n


STRESS = {  # tensor, and region of the measurement
    "aslant": (lambda x, y: along(0.8, 0.6), lambda x, y: True),
    "circles": (lambda x, y: along(*around(x, y)), lambda x, y: math.hypot(x - 40, y - 40) > 6),
    "waves": (lambda x, y: along(1, 0.4 * math.cos(x / 12)), lambda x, y: True),
    "hole": (kirsch, lambda x, y: math.hypot(x - 40, y - 40) > 20),
    "beam": (beam, lambda x, y: abs(y - 40) > 4),
}


def field_of(value):
    n, m = 41, 9
    return {"kind": "voxels", "count": [n, n, m], "origin": [-SIDE / 2, -SIDE / 2, 0], "spacing": [SIDE / (n - 1), SIDE / (n - 1), HEIGHT / (m - 1)],
            "values": [round(value(SIDE * i / (n - 1), SIDE * j / (n - 1), HEIGHT * k / (m - 1)), 5)
                       for k in range(m) for j in range(n) for i in range(n)]}


def stress_of(tensor):
    n = 81
    return {"kind": "voxels", "count": [n, n, 1], "origin": [-SIDE / 2, -SIDE / 2, 0], "spacing": [SIDE / (n - 1), SIDE / (n - 1), 1],
            "stress": [round(v, 6) for j in range(n) for i in range(n) for v in tensor(SIDE * i / (n - 1), SIDE * j / (n - 1))]}


def segments(path):
    """Returns (x0, y0, x1, y1, z, volume, width) of each move of the infill in the model's frame, and the number of
    paths.
    """
    word = re.compile(r"([XYZEF])([-+0-9.]+)")
    x = y = z = 0.0
    feature, width, run, paths = "", 0.0, False, 0
    low, found = [1e9, 1e9], []
    for line in open(path):
        if line.startswith(";TYPE:"):
            feature, run = line[6:].strip(), False
        if line.startswith(";WIDTH:"):
            width = float(line[7:])
        if not line.startswith("G1 "):
            continue
        values = {k: float(v) for k, v in word.findall(line.split(";")[0])}
        to_x, to_y = values.get("X", x), values.get("Y", y)
        z = values.get("Z", z)
        push = values.get("E", 0)
        moves = to_x != x or to_y != y
        if moves and push > 0:
            if feature == "External perimeter":
                low = [min(low[0], x - width / 2, to_x - width / 2), min(low[1], y - width / 2, to_y - width / 2)]
            if feature == "Internal infill":
                paths += not run
                run = True
                found.append((x, y, to_x, to_y, z, push * FILAMENT_MM2, width))
        elif moves:
            run = False
        x, y = to_x, to_y
    return [(a - low[0], b - low[1], c - low[0], d - low[1], *rest) for a, b, c, d, *rest in found], paths


def slice_box(folder, option, field, extra):
    (folder / "field.json").write_text(json.dumps(field))
    ini = (ROOT / "tests/corpus/config/peers.ini").read_text() + "\nperimeters = 1\ntop_solid_layers = 0\nbottom_solid_layers = 0\n"
    (folder / "box.ini").write_text(ini)
    with open(folder / "box.stl", "w") as out:
        subprocess.run([sys.executable, ROOT / "tests/bench/infill_box.py", "box"], stdout=out, check=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([ROOT / "build/bin/slicefarm", "slice", folder / "box.stl", "-q", "-o", folder / "box.gcode", "--threads", "1",
                    "--config", folder / "box.ini", option, folder / "field.json", *extra], check=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return segments(folder / "box.gcode"), after.ru_utime - before.ru_utime


def density_row(folder, name, pattern, dither):
    value = DENSITY[name]
    field = {"kind": "surface_distance", "near": 0.5, "far": 0.1, "length": 6} if name == "surface" else field_of(value)
    field["dither"] = dither
    (lines, paths), cpu = slice_box(folder, "--density-field", field, ["--set", f"fill_pattern={pattern}"])
    count = int((SIDE - 2 * INSET) / CELL)
    got = [[0.0] * count for _ in range(count)]
    for x0, y0, x1, y1, _, volume, _ in lines:
        steps = max(1, int(math.hypot(x1 - x0, y1 - y0) / 0.1))
        for k in range(steps):
            s = (k + 0.5) / steps
            i = int((x0 + s * (x1 - x0) - INSET) // CELL)
            j = int((y0 + s * (y1 - y0) - INSET) // CELL)
            if 0 <= i < count and 0 <= j < count:
                got[j][i] += volume / steps
    error = all_got = all_asked = 0
    for j in range(count):
        for i in range(count):
            places = [(INSET + CELL * (i + (a + 0.5) / 5), INSET + CELL * (j + (b + 0.5) / 5), HEIGHT * (c + 0.5) / 20)
                      for a in range(5) for b in range(5) for c in range(20)]
            asked = sum(value(*p) for p in places) / len(places) * CELL * CELL * HEIGHT
            error += abs(got[j][i] / asked - 1)
            all_got, all_asked = all_got + got[j][i], all_asked + asked
    print(f"{name} {pattern} {100 * error / count**2:.2f} {100 * (all_got / all_asked - 1):.2f} {paths} {cpu:.2f}", flush=True)


def stress_row(folder, name):
    density = 0.2
    (lines, _), cpu = slice_box(folder, "--stress-field", stress_of(STRESS[name][0]), ["--set", f"fill_density={100 * density}%"])
    heights = sorted({line[4] for line in lines})
    for family in (0, 1):
        stress_layer(name, family, density, [line for line in lines if line[4] == heights[40 + family]], cpu)


def stress_layer(name, family, density, lines, cpu):
    tensor, counts = STRESS[name]
    spacing = 0.45 - 0.2 * (1 - math.pi / 4)
    pitch = spacing / density
    grid = {}
    samples = []
    for n, (x0, y0, x1, y1, _, volume, _) in enumerate(lines):
        length = math.hypot(x1 - x0, y1 - y0)
        steps = max(1, int(length / 0.25))
        for k in range(steps):
            s = (k + 0.5) / steps
            x, y = x0 + s * (x1 - x0), y0 + s * (y1 - y0)
            grid.setdefault((int(x // pitch), int(y // pitch)), []).append((n, x, y))
            samples.append((x, y, (x1 - x0) / length, (y1 - y0) / length, length / steps, volume / steps))
    square = all_length = even = volume = 0
    for x, y, dx, dy, length, own in samples:
        if not (INSET < x < SIDE - INSET and INSET < y < SIDE - INSET and counts(x, y)):
            continue
        volume += own
        xx, yy, xy = tensor(x, y)
        angle = 0.5 * math.atan2(2 * xy, xx - yy) + (family + (xx + yy < 0)) * math.pi / 2
        off = math.degrees(math.asin(min(1, abs(dx * math.sin(angle) - dy * math.cos(angle)))))
        all_length += length
        square += off * off * length
        sides = {1: 1e9, -1: 1e9}
        for i in (-2, -1, 0, 1, 2):
            for j in (-2, -1, 0, 1, 2):
                for _, px, py in grid.get((int(x // pitch) + i, int(y // pitch) + j), ()):
                    ahead, across = (px - x) * dx + (py - y) * dy, (py - y) * dx - (px - x) * dy
                    if abs(ahead) < 0.3 and abs(across) > 0.3 * pitch:
                        side = 1 if across > 0 else -1
                        sides[side] = min(sides[side], abs(across))
        even += length * sum(0.5 for d in sides.values() if 0.8 * pitch <= d <= 1.2 * pitch)
    area = sum(1 for i in range(700) for j in range(700) if counts(INSET + 0.1 * i, INSET + 0.1 * j)) * 0.01
    print(f"{name} {family} {pitch:.2f} {math.sqrt(square / all_length):.2f} {even / all_length:.3f} "
          f"{volume / (0.2 * area * density):.3f} {cpu:.2f}", flush=True)


def main():
    dither = sys.argv.pop().split("=")[1] if sys.argv[-1].startswith("--dither=") else "none"
    patterns = sys.argv[1:] or ["rectilinear", "grid", "cubic", "gyroid"]
    os.chdir(ROOT)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        print("field pattern mean_error bias paths cpu_s")
        for field in DENSITY:
            for pattern in patterns:
                density_row(folder, field, pattern, dither)
        print("field family pitch angle_rms even got cpu_s")
        for field in STRESS:
            stress_row(folder, field)


if __name__ == "__main__":
    main()
