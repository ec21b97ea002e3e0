#!/usr/bin/env python3
"""Tests `slicefarm check` and `slicefarm time` on whole files:

- all G-code that `slice` makes of the corpus passes, for each flavour and each setting that changes its form;
- PrusaSlicer's G-code passes too;
- a fault inserted into a file is found at its line;
- the result of `time` agrees with the time stated in the file;
- arcs need far fewer moves, with the same filament.

usage: gcode_check_test.py SLICEFARM CORPUS
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

FLAVORS = {"klipper": "klipper", "marlin2": "marlin", "marlin": "marlin", "reprapfirmware": "rrf"}
MODELS = ["busted", "thin_walls", "textbox"]
# Settings that change the form of the G-code.
FORMS = {
    "plain": [],
    "told": ["default_acceleration=1000", "perimeter_acceleration=700", "travel_acceleration=2000",
             "machine_limits_usage=emit_to_gcode", "remaining_times=1", "retract_lift=0.2"],
    "labelled": ["gcode_label_objects=firmware", "brim_width=3", "skirts=1", "retract_restart_extra=0.05"],
    "arcs": ["arc_fitting=emit_center"],
    "wiped": ["wipe=1", "retract_before_wipe=30%", "retract_lift=0.2", "retract_lift_above=1", "retract_lift_below=5"],
    "absolute": ["use_relative_e_distances=0", "arc_fitting=emit_center", "wipe=1"],
    "volumes": ["use_volumetric_e=1", "use_relative_e_distances=0"],
    "by firmware": ["use_firmware_retraction=1", "retract_lift=0.2"],
    "commented": ["gcode_comments=1", "use_firmware_retraction=1", "use_relative_e_distances=0"],
}
NOT_FOR = {("volumes", "klipper")}  # Klipper has no M200


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)


def slice_model(program, model, output, settings):
    sets = [word for setting in settings for word in ("--set", setting)]
    done = run(program, "slice", model, "-o", output, "-q", "--set", "layer_height=0.3", *sets)
    assert done.returncode == 0, done.stderr


def check(program, path, flavor):
    done = run(program, "check", path, "--flavor", flavor)
    assert done.returncode in (0, 1), done.stderr
    return done.returncode, done.stdout


def passes(program, path, flavor, what):
    code, text = check(program, path, flavor)
    assert code == 0 and "\nfindings 0\n" in text, f"{what} for {flavor}:\n{text[:2000]}"


def rows(text):
    return dict(line.split(" ", 1) for line in text.splitlines())


def own_files_pass(program, corpus, folder):
    output = folder / "own.gcode"
    for name in MODELS:
        for flavor, reader in FLAVORS.items():
            for form, settings in FORMS.items():
                if name != MODELS[0] and form != "plain" and flavor != "klipper":
                    continue  # one model is enough for all forms in all flavours
                if (form, flavor) in NOT_FOR:
                    continue
                slice_model(program, corpus / "models" / f"{name}.stl", output, [f"gcode_flavor={flavor}", *settings])
                passes(program, output, reader, f"{name}, {form}, {flavor}")


def peers_files_pass(program, corpus):
    for flavor, readers in {"marlin2": ["marlin", "klipper"], "klipper": ["klipper", "marlin"], "reprapfirmware": ["rrf"]}.items():
        for reader in readers:
            passes(program, corpus / "gcode" / f"prusaslicer_{flavor}.gcode", reader, f"PrusaSlicer's {flavor}")


def edit(lines, pattern, change):
    """Changes the line of the second match of `pattern` after the first third; returns the lines and the number of the
    changed line, from 1.
    """
    found = [i for i, line in enumerate(lines) if i > len(lines) // 3 and re.match(pattern, line)]
    at = found[1]
    changed = change(lines[at])
    return lines[:at] + changed + lines[at + 1 :], at + 1


FAULTS = {
    "unknown command": (r"G1 X.*E", lambda line: ["M98765", line], "M98765"),
    "outside": (r"G1 X.*E", lambda line: ["G1 X999 Y50", line], "outside"),
    "below the bed": (r"G1 Z", lambda line: ["G1 Z-1", line], "outside"),
    "thick bead": (r"G1 X.*E", lambda line: [re.sub(r"E\S+", "E50", line)], "a bead of"),
    "no restart": (r"G1 E\.?\d", lambda line: [], "retracted by"),
    "no retraction": (r"G1 E-", lambda line: [], "without a retraction"),
    "malformed": (r"G1 X\S+ Y.*E", lambda line: [line.replace("Y", "Y-.")], "cannot be read"),
    "no speed": (r"G1 X.*E", lambda line: [line + " F0"], "F0"),
    "bad arc": (r"G1 X.*E", lambda line: ["G2 X100 Y100 I3 J0", line], "an arc begins"),
}


def faults_are_found(program, corpus, folder):
    good = folder / "good.gcode"
    slice_model(program, corpus / "models" / "busted.stl", good, ["gcode_flavor=marlin2"])
    lines = good.read_text().splitlines()
    bad = folder / "bad.gcode"
    for name, (pattern, change, want) in FAULTS.items():
        edited, number = edit(lines, pattern, change)
        bad.write_text("\n".join(edited) + "\n")
        code, text = check(program, bad, "marlin")
        findings = [line for line in text.splitlines() if line.startswith("line ")]
        assert code == 1 and any(want in line for line in findings), f"{name}: {text[:1000]}"
        if want in ("M98765", "outside", "a bead of", "F0", "an arc begins"):
            assert f"line {number}:" in text, f"{name}: not in line {number}: {text[:1000]}"
    bad.write_text("\n".join("; filament used [mm] = 1.00" if "filament used [mm]" in line else line for line in lines))
    code, text = check(program, bad, "marlin")
    assert code == 1 and "filament used" in text, text


def times_agree(program, corpus, folder):
    output, report = folder / "timed.gcode", folder / "timed.json"
    for flavor, name in ((f, n) for f in ("klipper", "marlin2", "reprapfirmware") for n in FORMS if (n, f) not in NOT_FOR):
        form = FORMS[name]
        sets = [word for setting in form for word in ("--set", setting)]
        done = run(program, "slice", corpus / "models" / "textbox.stl", "-o", output, "-q", "--report", report,
                   "--set", f"gcode_flavor={flavor}", "--set", "layer_height=0.3", *sets)
        assert done.returncode == 0, done.stderr
        own = json.loads(report.read_text())["print_time_s"]
        read = json.loads(run(program, "time", output, "--flavor", FLAVORS[flavor], "--json").stdout)
        # Code before the first layer is not the slicer's.
        whole = read["time_s"] - read["before_layers_s"]
        assert abs(own / whole - 1) < (5e-4 if flavor == "klipper" else 5e-3), f"{flavor} {form}: {own} {whole}"
        text = rows(run(program, "time", output, "--flavor", FLAVORS[flavor]).stdout)
        assert abs(float(text["time_s"]) - read["time_s"]) < 1e-5


def arcs_are_fewer(program, folder):
    """Checks on a cylinder of 20 mm diameter with 360 sides that arcs need at most a fifth of the moves."""
    import math

    sides = [(10 * math.cos(2 * math.pi * i / 360), 10 * math.sin(2 * math.pi * i / 360)) for i in range(360)]
    text = [f"v {x:.6f} {y:.6f} {z}" for z in (0, 5) for x, y in sides] + ["v 0 0 0", "v 0 0 5"]
    for i in range(360):
        a, b = i + 1, (i + 1) % 360 + 1
        text += [f"f {a} {b} {b + 360}", f"f {a} {b + 360} {a + 360}", f"f {b} {a} 721", f"f {a + 360} {b + 360} 722"]
    model = folder / "cylinder.obj"
    model.write_text("\n".join(text) + "\n")
    used, moves = {}, {}
    for form in ("disabled", "emit_center"):
        output = folder / f"{form}.gcode"
        slice_model(program, model, output, [f"arc_fitting={form}", "fill_density=0", "top_solid_layers=0", "bottom_solid_layers=0"])
        passes(program, output, "marlin", form)
        gcode = output.read_text()
        moves[form] = len(re.findall(r"^G[123] X.*E", gcode, re.M))
        used[form] = re.search(r"filament used \[mm\] = (\S+)", gcode).group(1)
    assert used["disabled"] == used["emit_center"], used
    assert moves["emit_center"] * 5 <= moves["disabled"], moves


def main():
    program, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        own_files_pass(program, corpus, folder)
        peers_files_pass(program, corpus)
        faults_are_found(program, corpus, folder)
        times_agree(program, corpus, folder)
        arcs_are_fewer(program, folder)
    print("every file passes, every fault is found")


if __name__ == "__main__":
    main()
