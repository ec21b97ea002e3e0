#!/usr/bin/env python3
"""Tests laser jobs from model to file. The exposed area must cover the part and stay inside it, and all formats must
have the same content. Settings of other processes are refused. A farm of real processes must produce the bytes of
`slicefarm slice`.

usage: laser_test.py SLICEFARM MODELS
"""
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile

USAGE, BAD_SETTING = 2, 3  # exit codes
BOX = (30.0, 20.0, 1.0)  # size in mm
LAYER = 0.1


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def must(program, *arguments):
    done = run(program, *arguments)
    assert done.returncode == 0, f"{arguments}: {done.returncode} {done.stderr}"
    return done.stdout


def write_box(path):
    x, y, z = BOX
    corners = [(a * x, b * y, c * z) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    path.write_text("".join(f"v {a} {b} {c}\n" for a, b, c in corners) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    return path


def laser(program, model, out, *settings, report=None):
    pairs = [part for setting in (f"layer_height={LAYER}", f"first_layer_height={LAYER}", *settings) for part in ("--set", setting)]
    must(program, "slice", model, "-o", out, "--machine", "laser", "-q", *pairs, *(["--report", report] if report else []))
    return out


def read_cli(data):
    """Reads the layers of a CLI file by the published format: {z: [(closed, points)]}, and the hatch lines of each
    layer.
    """
    header, _, body = data.partition(b"$$HEADEREND")
    text = header.decode()
    unit = float(re.search(r"\$\$UNITS/([\d.eE+-]+)", text).group(1))
    count = int(re.search(r"\$\$LAYERS/(\d+)", text).group(1))
    layers = read_binary(body, unit) if b"$$BINARY" in header else read_ascii(body.decode(), unit)
    assert len(layers) == count, f"{len(layers)} layers, and {count} in the header"
    return layers


def read_ascii(body, unit):
    layers = []
    for name, values in re.findall(r"\$\$([A-Z]+)(?:/([^$\s]*))?", body):
        numbers = [float(v) for v in values.split(",")] if values else []
        if name == "LAYER":
            layers.append((numbers[0] * unit, [], []))
        elif name == "POLYLINE":
            assert len(numbers) == 3 + 2 * numbers[2], numbers[:4]
            layers[-1][1].append([(x * unit, y * unit) for x, y in zip(numbers[3::2], numbers[4::2])])
        elif name == "HATCHES":
            assert len(numbers) == 2 + 4 * numbers[1], numbers[:3]
            layers[-1][2].extend(tuple(v * unit for v in numbers[i:i + 4]) for i in range(2, len(numbers), 4))
    return layers


def read_binary(body, unit):
    layers, at = [], 0

    def take(form):
        nonlocal at
        values = struct.unpack_from("<" + form, body, at)
        at += struct.calcsize("<" + form)
        return values
    while at + 2 <= len(body):
        command, = take("H")
        if command in (127, 128):
            layers.append((take("f" if command == 127 else "H")[0] * unit, [], []))
        elif command in (129, 130):
            size, real = ("H", "H") if command == 129 else ("i", "f")
            _, _, count = take(size * 3)
            points = take(real * (2 * count))
            layers[-1][1].append([(x * unit, y * unit) for x, y in zip(points[::2], points[1::2])])
        elif command in (131, 132):
            size, real = ("H", "H") if command == 131 else ("i", "f")
            _, count = take(size * 2)
            values = take(real * (4 * count))
            layers[-1][2].extend(tuple(v * unit for v in values[i:i + 4]) for i in range(0, len(values), 4))
        else:
            raise AssertionError(f"command {command} at {at}")
    return layers


def length_of(layer):
    lines = sum(math.dist(a, b) for line in layer[1] for a, b in zip(line, line[1:]))
    return lines, sum(math.dist(h[:2], h[2:]) for h in layer[2])


def points_of(layer):
    for line in layer[1]:
        yield from line
    for hatch in layer[2]:
        yield hatch[:2]
        yield hatch[2:]


def check_strategies(program, models, folder):
    """Checks that the exposed length is the area divided by the hatch distance, and that no exposure is outside the
    compensated outline.
    """
    box = write_box(folder / "box.obj")
    for strategy in ("rings", "rings_inward", "stripes", "islands", "hatch"):
        out = laser(program, box, folder / "box.cli", f"scan_strategy={strategy}", "hatch_distance=0.2", "contours=1", "scan_overlap=0", "ring_corners=0",
                    "bed_shape=0x0,100x0,100x100,0x100", report=folder / "report.json")
        layers = read_cli(out.read_bytes())
        assert len(layers) == round(BOX[2] / LAYER), len(layers)
        middle = layers[5]
        inside = 0.04 - 2e-3  # beam compensation less a unit of the file
        for x, y in points_of(middle):
            assert abs(x - 50) <= BOX[0] / 2 - inside and abs(y - 50) <= BOX[1] / 2 - inside, f"{strategy}: {x} {y}"
        wanted = (BOX[0] - 0.2) * (BOX[1] - 0.2) / 0.2
        contour = 2 * (BOX[0] + BOX[1]) - 8 * 0.04
        lines, hatches = length_of(middle)
        assert abs(lines + hatches - contour - wanted) < 0.03 * wanted, f"{strategy}: {lines} {hatches} {wanted}"
        report = json.loads((folder / "report.json").read_text())
        total = sum(sum(length_of(layer)) for layer in layers)
        assert abs(report["exposure"]["exposed_mm"] / total - 1) < 1e-3, f"{strategy}: {report['exposure']['exposed_mm']} {total}"
        assert report["exposure"]["laser_on"] > 0 and report["exposure"]["energy_density_j_mm3"] > 0
        assert report["layers"] == len(layers) and "filament" not in report


def check_rotation(program, models, folder):
    box = write_box(folder / "box.obj")
    layers = read_cli(laser(program, box, folder / "turn.cli", "scan_strategy=hatch", "hatch_angle=10", "hatch_rotation=67").read_bytes())
    for number, layer in enumerate(layers):
        x0, y0, x1, y1 = max(layer[2], key=lambda h: math.dist(h[:2], h[2:]))
        angle = math.degrees(math.atan2(y1 - y0, x1 - x0)) % 180
        off = (angle - 10 - 67 * number) % 180
        assert min(off, 180 - off) < 0.1, f"layer {number}: {angle}"


def check_formats(program, models, folder):
    """Checks that both kinds of CLI have the same geometry, and that in G-code the laser is off in every jump and at
    the end.
    """
    text = read_cli(laser(program, models / "textbox.stl", folder / "text.cli").read_bytes())
    binary = read_cli(laser(program, models / "textbox.stl", folder / "binary.cli", "output_format=cli_binary").read_bytes())
    assert len(text) == len(binary)
    for a, b in zip(text, binary):
        assert len(a[1]) == len(b[1]) and len(a[2]) == len(b[2])
        assert all(math.dist(p, q) < 0.02 for p, q in zip(points_of(a), points_of(b)))
    for name, flavor in (("out.nc", "grbl"), ("out.gcode", "marlin")):
        out = laser(program, models / "textbox.stl", folder / name)
        check_gcode(out.read_text())
        assert "findings 0" in must(program, "check", out, "--flavor", flavor)
    assert laser(program, models / "textbox.stl", folder / "out.svg").read_text().count("<g") >= len(text)
    dxf = laser(program, models / "textbox.stl", folder / "out.dxf", "output_layer=3").read_text()
    assert dxf.rstrip().endswith("EOF") and "ENTITIES" in dxf


def check_gcode(gcode):
    on, lines = False, 0
    for line in gcode.splitlines():
        words = line.split(";")[0].split()
        if not words:
            continue
        power = next((float(w[1:]) for w in words if w[0] == "S"), None)
        if words[0] in ("M3", "M4"):
            on = power is None or power > 0
        elif words[0] == "M5":
            on = False
        elif words[0] in ("G1", "G2", "G3") and power is not None:
            on = power > 0
        elif words[0] == "G0":
            assert not on or words[0] == "G0", line  # the controller switches it off in a G0
        lines += words[0] == "G1"
    assert lines > 100 and not on, "the laser is on at the end"


def check_models(program, models, folder):
    """Checks that outlines of real models are exposed by the two strategies that cut them into pieces."""
    for model in sorted(models.glob("*.stl")):
        for strategy in ("rings", "stripes"):
            layers = read_cli(laser(program, model, folder / "model.cli", "layer_height=0.3", f"scan_strategy={strategy}").read_bytes())
            assert sum(length_of(layer)[0] + length_of(layer)[1] for layer in layers) > 100, f"{model.name} {strategy}"


def check_refusals(program, models, folder):
    model = models / "textbox.stl"
    for arguments, code, words in (
            (["--machine", "laser", "--set", "perimeters=3"], BAD_SETTING, "process fdm"),
            (["--set", "hatch_distance=0.1"], BAD_SETTING, "process laser"),
            (["--machine", "laser", "--set", "scan_strategy=spirals"], BAD_SETTING, "rings"),
            (["--machine", "laser", "--set", "stripe_width=0.1"], BAD_SETTING, "scan_overlap"),
            (["--machine", "laser", "--set", "output_format=dxf", "--set", "output_layer=99999"], BAD_SETTING, "output_layer")):
        done = run(program, "slice", model, "-o", folder / "bad.out", *arguments)
        assert done.returncode == code and words in done.stderr, f"{arguments}: {done.returncode} {done.stderr}"
        assert not (folder / "bad.out").exists()
    assert run(program, "slice", model, "-o", folder / "bad.out", "--machine", "lathe").returncode not in (0, None)


def check_farm(program, models, folder):
    """Checks that a farm produces the same bytes as the command line, with fused workers and with split stages, also
    for parts with their own settings.
    """
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    model = models / "textbox.stl"
    given = ["--machine", "laser", "--set", f"layer_height={LAYER}", "--set", "scan_strategy=islands", "--set", "downskin_layers=2",
             "--copies", "textbox.stl=2", "--object-set", "textbox.stl:hatch_power=150"]
    must(program, "slice", model, "-o", folder / "here.cli", "-q", *given)
    here = (folder / "here.cli").read_bytes()
    for split in (False, True):
        with running_farm(split=split) as farm:
            done = farm.client("submit", model, "-o", folder / "there.cli", "-q", *given)
            assert done.returncode == 0, done.stderr
            assert (folder / "there.cli").read_bytes() == here, f"split {split}"
            check = farm.client("submit", model, "--check", *given)
            assert check.returncode == 0 and "layers" in check.stdout, check.stderr
            fdm = farm.client("submit", model, "-o", folder / "there.gcode", "-q")
            assert fdm.returncode == 0, fdm.stderr


def main(program, models):
    with tempfile.TemporaryDirectory() as name:
        for check in (check_strategies, check_rotation, check_formats, check_models, check_refusals, check_farm):
            check(program, pathlib.Path(models), pathlib.Path(name))
            print(f"{check.__name__}: ok")


if __name__ == "__main__":
    main(*sys.argv[1:])
