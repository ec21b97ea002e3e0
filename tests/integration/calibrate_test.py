#!/usr/bin/env python3
"""Tests `slicefarm calibrate`: each kind makes a program that varies its value as the table of the report says.

- the command of each floor stands once, before the first layer of the floor and after the last one of the floor below;
- walls of a floor have the speed of the table, measured in the program;
- plates have the flow of the table: extrusion per mm of the top surface;
- retractions have the length of the table, and each restart feeds what the retraction before it pulled, also between floors;
- lines and patterns of pressure advance have the command of each value before its lines, within the frame, in each layer;
- the values are the same from --config and from presets; wrong values are refused with the name of the option.

usage: calibrate_test.py SLICEFARM
"""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

CONFIG = """gcode_flavor = klipper
bed_shape = 0x0,250x0,250x250,0x250
nozzle_diameter = 0.4
layer_height = 0.2
first_layer_height = 0.2
temperature = 215
first_layer_temperature = 215
external_perimeter_extrusion_width = 0.45
machine_max_feedrate_x = 500
machine_max_feedrate_y = 500
filament_max_volumetric_speed = 15
max_volumetric_speed = 12
extrusion_multiplier = 1
skirts = 0
"""
CODES = {
    "temperature": (r"M104 S([\d.]+)", [230, 225, 220, 215, 210, 205, 200]),
    "pressure-advance": (r"SET_PRESSURE_ADVANCE ADVANCE=([\d.]+)", [i / 100 for i in range(11)]),
    "retraction": (r"; retract_length = ([\d.]+)", [i / 5 for i in range(11)]),
    "cornering": (r"SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=([\d.]+)", list(range(1, 16))),
    "input-shaping": (r"SET_INPUT_SHAPER SHAPER_FREQ_X=([\d.]+) SHAPER_FREQ_Y=\1", list(range(15, 111, 5))),
}


def run(program, *words):
    return subprocess.run([str(program), *map(str, words)], capture_output=True, text=True)


def calibrated(program, folder, *words):
    output, report = folder / "out.gcode", folder / "out.json"
    done = run(program, "calibrate", *words, "-o", output, "--report", report, "-q")
    assert done.returncode == 0, (words, done.stderr)
    table = json.loads(report.read_text())["calibration"]
    return output.read_text(), table


def without_end(gcode):
    """Returns the program without the end G-code."""
    return gcode[:max(gcode.rfind(";TYPE:Custom"), gcode.rfind("; FEATURE: Custom"))]


def layers(gcode):
    """Yields (z, lines) of each layer; z of the text before the layers is 0. Custom code of a layer is before its Z move."""
    for part in re.split(r"^;LAYER_CHANGE\n|^; CHANGE_LAYER\n", gcode, flags=re.M):
        z = re.match(r"(?:;Z:|; Z_HEIGHT: )([\d.]+)", part)
        yield (float(z[1]) if z else 0), part.splitlines()


def moves(lines):
    """Yields (feature, length, extrusion, speed) of each bead, for relative E."""
    x = y = None
    speed = 0
    feature = ""
    for line in lines:
        if line.startswith(";TYPE:"):
            feature = line[6:]
        words = dict(re.findall(r"([XYZEF])(-?[\d.]+)", line.split(";")[0])) if line.startswith("G1") else {}
        speed = float(words.get("F", speed * 60)) / 60
        known = x is not None and y is not None
        to_x, to_y = (float(words[key]) if key in words else here for key, here in (("X", x), ("Y", y)))
        length = math.hypot(to_x - x, to_y - y) if known else 0
        x, y = to_x, to_y
        if length > 0 and float(words.get("E", 0)) > 0:
            yield feature, length, float(words["E"]), speed


def check_codes(program, folder, config):
    for kind, (pattern, wanted) in CODES.items():
        gcode, table = calibrated(program, folder, kind, "--config", config)
        assert table["kind"] == kind and [round(row["value"], 6) for row in table["values"]] == wanted, table
        gcode = without_end(gcode)
        found = [(z, float(match[1])) for z, lines in layers(gcode) if z > 0 for line in lines if (match := re.match(pattern, line))]
        assert [value for _, value in found] == wanted, (kind, found)
        for (z, _), row in zip(found, table["values"]):
            first = 0.2 if row is table["values"][0] else row["from_mm"] + 0.2
            assert abs(z - first) < 1e-6, (kind, z, row)
        top = max(z for z, _ in layers(gcode))
        assert abs(top - table["values"][-1]["to_mm"]) < 1e-6, (kind, top)


def check_speeds(program, folder, config):
    for kind, settings, per_mm in (("vfa", ["--end", 120, "--step", 40], 1), ("volumetric-speed", ["--end", 20, "--step", 5], None)):
        gcode, table = calibrated(program, folder, kind, "--config", config, *settings)
        for row in table["values"]:
            inside = moves(line for z, lines in layers(gcode) if row["from_mm"] + 0.21 < z < row["to_mm"] + 0.01 for line in lines)
            walls = [each for each in inside if each[0] == "External perimeter" and each[1] > 5]
            assert walls, (kind, row)
            for _, length, extrusion, speed in walls:
                got = speed if per_mm else speed * extrusion / length * math.pi * 1.75 ** 2 / 4
                assert abs(got - row["value"]) < 0.02 * row["value"], (kind, row, got)


def check_flow(program, folder, config):
    for words, count in (([], 9), (["--fine"], 10)):
        gcode, table = calibrated(program, folder, "flow", "--config", config, "--set", "gcode_label_objects=octoprint", *words)
        assert len(table["values"]) == count
        flows = {}
        for name in (row["object"] for row in table["values"]):
            blocks = re.findall(rf"^; printing object {re.escape(name)} id:.*?\n(.*?)^; stop printing object", gcode, re.M | re.S)
            top = [each for block in blocks for each in moves(block.splitlines()) if each[0] == "Top solid infill" and each[1] > 10]
            flows[name] = sum(each[2] for each in top) / sum(each[1] for each in top)
        for row in table["values"]:
            ratio = flows[row["object"]] / flows["flow 0"]
            assert abs(ratio - row["value"]) < 0.01, (row, ratio)


def retractions(lines):
    """Returns the lengths of retractions. Checks that each bead begins with a filament that is fed as far as it was pulled."""
    pulled, lengths = None, []
    for line in lines:
        words = dict(re.findall(r"([XYE])(-?[\d.]+)", line.split(";")[0])) if line.startswith("G1") else {}
        feed = float(words.get("E", 0))
        if "X" in words or "Y" in words:
            assert feed <= 0 or pulled is None or abs(pulled) < 1e-4, (line, pulled)
            if feed > 0:
                pulled = 0
        elif pulled is not None:
            pulled += feed
            if feed < 0:
                lengths.append(round(-feed, 5))
    return lengths


def check_retraction(program, folder, config):
    for flavor in ("klipper", "bambu", "prusabuddy", "marlin"):
        gcode, table = calibrated(program, folder, "retraction", "--config", config, "--set", f"gcode_flavor={flavor}")
        retractions(without_end(gcode).splitlines())
        for row in table["values"]:
            lines = [line for z, lines in layers(gcode) if row["from_mm"] + 0.3 < z < row["to_mm"] + 0.01 for line in lines]
            lengths = retractions(lines)
            assert set(lengths) == ({round(row["value"], 5)} if row["value"] > 0 else set()), (flavor, row, set(lengths))
    gcode, table = calibrated(program, folder, "retraction", "--config", config, "--set", "use_firmware_retraction=1")
    assert re.findall(r"^SET_RETRACTION RETRACT_LENGTH=([\d.]+)", gcode, re.M) == [f"{row['value']:g}" for row in table["values"]]


def check_lines(program, folder, config):
    for method, count, of_layer in (("line", 1, 3), ("pattern", 4, 6)):
        gcode, table = calibrated(program, folder, "pressure-advance", "--method", method, "--config", config)
        done = run(program, "check", folder / "out.gcode", "--config", config)
        assert done.returncode == 0, (method, done.stdout)
        retractions(without_end(gcode).splitlines())
        first = [move for z, lines in layers(gcode) if abs(z - 0.2) < 1e-6 for move in moves(lines)]
        walls = sum(length for feature, length, _, _ in first if "perimeter" in feature.lower())
        assert walls > 600, (method, walls, "the frame is in the first layer")
        parts = [(z, "\n".join(lines)) for z, lines in layers(gcode) if ";CUSTOM_GCODE" in lines]
        assert [round(z, 3) for z, _ in parts] == [round(0.2 * (i + 1), 3) for i in range(count)], (method, parts)
        for _, text in parts:
            blocks = re.split(r"^SET_PRESSURE_ADVANCE ADVANCE=", text[:text.index(";TYPE:")], flags=re.M)[1:]
            assert [float(block.split()[0]) for block in blocks] == [round(row["value"], 6) for row in table["values"]] + [0]
            for block in blocks[:-1]:
                assert len(re.findall(r"^G1 X[\d.]+ Y[\d.]+ E", block, re.M)) == of_layer, (method, block)
    corner = ["--set", "bed_shape=0x0,60x0,60x60,0x60"]
    done = run(program, "calibrate", "pressure-advance", "--method", "line", "-o", folder / "no.gcode", "--config", config, *corner)
    assert done.returncode == 4 and "pressure-advance lines" in done.stderr, done


def check_refusals(program, folder, config):
    cases = [
        (["temperature", "--step", "0"], 2, "--step"),
        (["temperature", "--start", "20"], 2, "between"),
        (["vfa", "--step", "0.1"], 2, "values"),
        (["vfa", "--end", "600"], 3, "machine_max_feedrate_x"),
        (["input-shaping", "--set", "gcode_flavor=bambu"], 3, "gcode_flavor"),
        (["vfa", "--method", "line"], 2, "--method"),
        (["vfa", "--fine"], 2, "--fine"),
        (["temperatur"], 2, "temperature"),
    ]
    for words, code, message in cases:
        done = run(program, "calibrate", *words, "-o", folder / "no.gcode", "--config", config)
        assert done.returncode == code and message in done.stderr and not (folder / "no.gcode").exists(), (words, done)


def check_presets(program, folder, config):
    bundle = folder / "bundle.ini"
    bundle.write_text("[printer:P]\ngcode_flavor = klipper\nbed_shape = 0x0,250x0,250x250,0x250\nnozzle_diameter = 0.4\n"
                      "machine_max_feedrate_x = 500\nmachine_max_feedrate_y = 500\ndefault_print_profile = Q\ndefault_filament_profile = F\n\n"
                      "[print:Q]\nlayer_height = 0.2\nfirst_layer_height = 0.2\nskirts = 0\n\n[filament:F]\ntemperature = 215\nfirst_layer_temperature = 215\n")
    _, table = calibrated(program, folder, "temperature", "--presets", bundle, "--printer", "P", "--filament", "F")
    assert [row["value"] for row in table["values"]] == CODES["temperature"][1]


def main():
    program = sys.argv[1]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        config = folder / "printer.ini"
        config.write_text(CONFIG)
        for check in (check_codes, check_speeds, check_flow, check_retraction, check_lines, check_refusals, check_presets):
            check(program, folder, config)
            print(check.__name__)


main()
