#!/usr/bin/env python3
"""Tests presets that a farm of real processes stores: import, jobs that name them, revisions, overlays, projects for
another printer, and the sources of settings. The G-code must equal that of `slice --presets`.

usage: farm_presets_test.py SLICEFARM
"""
import json
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, call, running_farm

MODEL = MODELS / "textbox.stl"
PROJECT = MODELS / "textbox.3mf"


def bundle(walls):
    return f"""[vendor]
name = Acme
[printer_model:A]
name = Acme A
[print:0.20mm FAST @A]
layer_height = 0.2
perimeters = {walls}
[filament:PLA @A]
filament_type = PLA
temperature = 207
[printer:Acme A]
printer_model = A
nozzle_diameter = 0.4
gcode_flavor = marlin2
bed_shape = 0x0,180x0,180x180,0x180
start_gcode = ACME [temperature]
default_print_profile = 0.20mm FAST @A
default_filament_profile = PLA @A
"""


def same_bytes(farm, folder, model, presets, *more):
    """Makes a job with the farm's presets and with the files, compares the G-code, and returns it with the job."""
    on_farm, here = folder / "farm.gcode", folder / "here.gcode"
    job = json.loads(call(farm, "submit", model, "-o", on_farm, "--json", "--printer", "Acme A", *more))
    subprocess.run([BIN / "slicefarm", "slice", model, "-o", here, "-q", "--presets", presets, "--printer", "Acme A"], check=True,
                   capture_output=True)
    assert on_farm.read_bytes() == here.read_bytes()
    return on_farm.read_text(), json.loads(call(farm, "get", job["id"]))


def source_of(sources, key):
    found = [each["source"] for each in sources if key in each["keys"]]
    assert len(found) == 1, (key, sources)
    return found[0]


def check_revisions(farm, folder):
    old, new = folder / "1" / "Acme.ini", folder / "2" / "Acme.ini"
    for path, walls in ((old, 3), (new, 5)):
        path.parent.mkdir()
        path.write_text(bundle(walls))
        assert call(farm, "presets", "import", path).startswith(f"Acme@{path.parent.name}: 3 presets")
    assert call(farm, "presets", "import", new).startswith("Acme@2:"), "equal files add no revision"
    (new.parent / "blacklist.json").write_text('{"machine_list": []}')
    assert call(farm, "presets", "import", new.parent).startswith("Acme@2:"), "a list without presets is left out"
    assert "0.20mm FAST @A" in call(farm, "presets", "list", "--printer", "Acme A")
    assert "perimeters = 5  # 0.20mm FAST @A" in call(farm, "presets", "show", "--printer", "Acme A")
    assert call(farm, "presets", "bundles").splitlines()[1].split()[:2] == ["Acme", "2"]
    gcode, job = same_bytes(farm, folder, MODEL, new)
    assert "; perimeters = 5\n" in gcode and "ACME 207" in gcode
    assert job["spec"]["presets"] == {"printer": "Acme A", "process": "0.20mm FAST @A", "filament": "PLA @A", "bundles": ["Acme@2"]}
    gcode, job = same_bytes(farm, folder, MODEL, old, "--bundle", "Acme@1")
    assert "; perimeters = 3\n" in gcode and job["spec"]["presets"]["bundles"] == ["Acme@1"]


def check_sources(farm, folder):
    call(farm, "profile", "put", "acme-07", "--set", "extrusion_multiplier=0.97")
    out, report = folder / "out.gcode", folder / "report.json"
    job = json.loads(call(farm, "submit", MODEL, "-o", out, "--report", report, "--json", "--printer", "Acme A", "--filament", "PLA",
                          "--profile", "acme-07", "--set", "fill_density=5%"))
    expected = {"extrusion_multiplier": "profile acme-07@1", "fill_density": "job",
                "perimeters": 'process preset "0.20mm FAST @A" (Acme@2/Acme.ini)',
                "temperature": 'filament preset "PLA @A" (Acme@2/Acme.ini)'}
    told = json.loads(call(farm, "get", job["id"]))["spec"]["setting_sources"]
    reported = json.loads(report.read_text())["setting_sources"]
    for key, source in expected.items():
        assert source_of(told, key) == source_of(reported, key) == source
    assert "; extrusion_multiplier = 0.97\n" in out.read_text()


def check_projects(farm, folder):
    gcode, job = same_bytes(farm, folder, PROJECT, folder / "2" / "Acme.ini")
    assert "; bed_shape = 0x0,180x0,180x180,0x180\n" in gcode and "ACME 207" in gcode
    assert source_of(job["spec"]["setting_sources"], "bed_shape") == 'printer preset "Acme A" (Acme@2/Acme.ini)'
    assert "presets" not in job["spec"], "the settings were made by the client"


def check_errors(farm):
    for arguments, message in ((["--printer", "Acme B"], 'do you mean "Acme A"?'), (["--printer", "Acme A", "--bundle", "Acme@9"], "Acme@9")):
        done = farm.client("submit", MODEL, "--detach", *arguments)
        assert done.returncode != 0 and message in done.stderr, done.stderr
    call(farm, "presets", "delete", "Acme")
    done = farm.client("submit", MODEL, "--detach", "--printer", "Acme A")
    assert done.returncode != 0 and "presets import" in done.stderr, done.stderr


def main(_):
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as name, running_farm() as farm:
        folder = pathlib.Path(name)
        check_revisions(farm, folder)
        check_sources(farm, folder)
        check_projects(farm, folder)
        check_errors(farm)
    print("jobs have the presets that the farm stores")


if __name__ == "__main__":
    main(*sys.argv[1:])
