#!/usr/bin/env python3
"""Tests calibration prints as jobs of a farm of real processes.

- The G-code of `calibrate --server` equals that of `calibrate -o` on this machine, with presets of the farm, presets of files
  and --config.
- The report and the job have the table of values.
- `calibrate apply` stores the chosen value in the overlay of the printer and filament. The next jobs for them get the value
  without naming the overlay, also calibration prints and projects. Jobs of other filaments do not get it. Two calls at the same
  time lose no value.

usage: farm_calibrate_test.py SLICEFARM
"""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, call, running_farm

BUNDLE = """[vendor]
name = Acme
[printer_model:A]
name = Acme A
[print:FAST]
layer_height = 0.2
first_layer_height = 0.2
skirts = 0
[filament:PLA]
temperature = 207
first_layer_temperature = 207
extrusion_multiplier = 0.9
[filament:PETG]
temperature = 240
first_layer_temperature = 240
[printer:Acme A]
printer_model = A
nozzle_diameter = 0.4
gcode_flavor = marlin2
machine_max_feedrate_x = 500
machine_max_feedrate_y = 500
bed_shape = 0x0,220x0,220x220,0x220
default_print_profile = FAST
default_filament_profile = PLA
"""
OVERLAY = "overlay.Acme_A__with__PLA"


def refused(farm, message, *arguments):
    done = farm.client(*arguments)
    assert done.returncode != 0 and message in done.stderr, (arguments, done)


def local(*arguments):
    subprocess.run([BIN / "slicefarm", *arguments], check=True, capture_output=True)


def check_same(farm, folder, presets):
    """Compares prints of the farm with prints of this machine. Returns the job of the last one."""
    config = folder / "printer.ini"
    config.write_text("gcode_flavor = klipper\nbed_shape = 0x0,220x0,220x220,0x220\nnozzle_diameter = 0.4\n")
    cases = [("temperature", "--printer", "Acme A"), ("vfa", "--config", config, "--end", "80"),
             ("flow", "--printer", "Acme A", "--presets", presets), ("pressure-advance", "--printer", "Acme A", "--step", "0.02")]
    for kind, *words in cases:
        farm_gcode, here, reports = folder / "farm.gcode", folder / "here.gcode", [folder / "farm.json", folder / "here.json"]
        job = json.loads(call(farm, "calibrate", kind, "-o", farm_gcode, "--report", reports[0], "--json", *words))
        if "--printer" in words and "--presets" not in words:
            words = [*words, "--presets", presets]
        local("calibrate", kind, "-o", here, "--report", reports[1], "-q", *words)
        assert farm_gcode.read_bytes() == here.read_bytes(), kind
        tables = [json.loads(report.read_text())["calibration"] for report in reports]
        assert tables[0] == tables[1] and len(tables[0]["values"]) > 2 and tables[0]["kind"] == kind, tables
        stored = json.loads(call(farm, "get", job["id"]))["spec"]["calibration"]
        assert [row["label"] for row in stored["values"]] == [row["label"] for row in tables[0]["values"]]
    return job["id"]


def settings_of_job(farm, folder, *arguments):
    """Returns the settings in the G-code, and the sources of settings of the job."""
    out = folder / "job.gcode"
    job = json.loads(call(farm, "submit", "-o", out, "--json", "--printer", "Acme A", *arguments))
    lines = [line[2:].split(" = ", 1) for line in out.read_text().splitlines() if line.startswith("; ") and " = " in line]
    sources = json.loads(call(farm, "get", job["id"]))["spec"]["setting_sources"]
    return dict(lines), {key: each["source"] for each in sources for key in each["keys"]}


def check_apply(farm, folder, job):
    stored = call(farm, "calibrate", "apply", job, "0.05")
    assert stored == f"{OVERLAY}@1\n  pressure_advance = 0.05\n", stored
    assert call(farm, "calibrate", "apply", job[:8], "0.04").startswith(f"{OVERLAY}@2\n")
    for model in (MODELS / "textbox.stl", MODELS / "textbox.3mf"):
        settings, sources = settings_of_job(farm, folder, model)
        assert settings["pressure_advance"] == "0.04", model
        assert sources["pressure_advance"] == f"profile {OVERLAY}@2", sources
    settings, _ = settings_of_job(farm, folder, MODELS / "textbox.stl", "--filament", "PETG")
    assert settings["pressure_advance"] == "0"
    settings, _ = settings_of_job(farm, folder, MODELS / "textbox.stl", "--profile", f"{OVERLAY}@1")
    assert settings["pressure_advance"] == "0.05"


def check_second_pass(farm, folder):
    """The second print of flow begins with the value that the first one gave, and other values of the overlay stay."""
    first = call(farm, "calibrate", "flow", "--detach", "--printer", "Acme A").strip()
    assert "extrusion_multiplier = 0.945\n" in call(farm, "calibrate", "apply", first, "+5")
    report = folder / "fine.json"
    call(farm, "calibrate", "flow", "--fine", "-o", folder / "fine.gcode", "--report", report, "--printer", "Acme A")
    values = json.loads(report.read_text())["calibration"]["values"]
    assert abs(values[-1]["value"] - 0.945) < 1e-9 and values[-1]["label"] == "0", values
    profile = call(farm, "profile", "get", OVERLAY)
    assert "pressure_advance = 0.04\n" in profile and "extrusion_multiplier = 0.945\n" in profile, profile
    jerk = call(farm, "calibrate", "cornering", "--detach", "--printer", "Acme A").strip()
    assert call(farm, "calibrate", "apply", jerk, "7.5").startswith("overlay.Acme_A@1\n  machine_max_jerk_x = 7.5\n  machine_max_jerk_y = 7.5")
    call(farm, "calibrate", "apply", jerk, "8", "--profile", "acme-07")
    assert "machine_max_jerk_x = 8" in call(farm, "profile", "get", "acme-07")
    return first


def check_two_writers(farm, advance, flow):
    """Two calls at the same time change different settings of one profile. Neither loses the other's value."""
    server = ("--server", farm.coordinators[0].address, "--profile", "shared")
    for turn in range(1, 11):
        values = {advance: f"0.0{turn % 9 + 1}", flow: f"+{turn % 5 + 1}"}
        calls = [subprocess.Popen([BIN / "slicefarm", "calibrate", "apply", job, value, *server], stdout=subprocess.PIPE, text=True)
                 for job, value in values.items()]
        printed = [each.communicate()[0] for each in calls]
        assert all(each.returncode == 0 for each in calls), printed
        profile = call(farm, "profile", "get", "shared")
        for text in printed:
            assert text.split("\n")[1].strip() + "\n" in profile, (turn, printed, profile)


def check_refusals(farm, job):
    refused(farm, "0 to 0.1 s", "calibrate", "apply", job, "0.2")
    plain = call(farm, "submit", MODELS / "textbox.stl", "--detach", "--generic").strip()
    refused(farm, "no calibration print", "calibrate", "apply", plain, "1")
    shaper = call(farm, "calibrate", "input-shaping", "--detach", "--printer", "Acme A").strip()
    refused(farm, "firmware", "calibrate", "apply", shaper, "40")
    nameless = call(farm, "calibrate", "vfa", "--detach", "--generic").strip()
    refused(farm, "--profile NAME", "calibrate", "apply", nameless, "60")
    refused(farm, 'do you mean "Acme A"?', "calibrate", "vfa", "--detach", "--printer", "Acme B")


def main(_):
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as name, running_farm() as farm:
        folder = pathlib.Path(name)
        presets = folder / "Acme.ini"
        presets.write_text(BUNDLE)
        call(farm, "presets", "import", presets)
        job = check_same(farm, folder, presets)
        check_apply(farm, folder, job)
        flow = check_second_pass(farm, folder)
        check_two_writers(farm, job, flow)
        check_refusals(farm, job)
    print("calibration prints of the farm equal those of this machine, and their values reach the next jobs")


if __name__ == "__main__":
    main(*sys.argv[1:])
