#!/usr/bin/env python3
"""Tests the shares of objects and copies in reports:

- the sum over all copies and the shared part equals the total of the print, exactly and in any order;
- a copy's filament equals the extrusion between its labels in the G-code, read independently;
- the order of the models does not change an object's filament;
- copies of one object have equal filament, on one plate and over several plates;
- a farm returns the shares of the local report, with costs that add up to the job's cost.

usage: shares_test.py SLICEFARM MODELS
"""
import collections
import itertools
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

COMMON = ["--generic", "-q", "--set", "layer_height=0.3", "--set", "fill_density=8%", "--set", "filament_cost=25", "--set",
          "gcode_label_objects=octoprint", "--set", "filament_density=1.24"]
UNIT = 2 ** -20  # rounding unit of a share

Job = collections.namedtuple("Job", "name arguments copies")
JOBS = [
    Job("one object", ["busted.stl"], [1]),
    Job("three objects with copies", ["busted.stl", "textbox.stl", "thin_walls.stl", "--copies", "busted.stl=3", "--copies", "thin_walls.stl=2"], [3, 1, 2]),
    Job("one after another", ["textbox.stl", "busted.stl", "--copies", "busted.stl=2", "--set", "complete_objects=1"], [1, 2]),
    Job("raft, brim and supports", ["busted.stl", "textbox.stl", "--set", "raft_layers=2", "--set", "support_material=1", "--set", "brim_width=3",
                                    "--set", "skirts=2"], [1, 1]),
    Job("no skirt, retractions and wipes", ["busted.stl", "textbox.stl", "--set", "skirts=0", "--set", "wipe=1", "--set", "retract_lift=0.4"], [1, 1]),
    Job("klipper with heating", ["busted.stl", "--copies", "busted.stl=2", "--set", "gcode_flavor=klipper", "--set", "nozzle_heating_rate=2"], [2]),
]


def slice_models(program, folder, models, arguments, name="out"):
    paths = [str(models / a) if a.endswith(".stl") else a for a in arguments]
    command = [program, "slice", *paths, *COMMON, "-o", folder / f"{name}.gcode", "--report", folder / f"{name}.json"]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return json.loads((folder / f"{name}.json").read_text()) if (folder / f"{name}.json").exists() else None


def amounts(share):
    return (share["time_s"], *(share["filament"][key] for key in ("mm", "mm3", "g", "cost")))


def total_of(report):
    return (report["print_time_s"], *(report["filament"][key] for key in ("mm", "mm3", "g", "cost")))


def added(shares):
    return tuple(sum(column) for column in zip(*shares))


def adds_up(report, job):
    assert [len(each["copies"]) for each in report["objects"]] == job.copies, job.name
    copies = [amounts(copy) for each in report["objects"] for copy in each["copies"]]
    parts = [*copies, amounts(report["shared"])]
    for order in (parts, parts[::-1], sorted(parts)):
        assert added(order) == total_of(report), (job.name, added(order), total_of(report))
    for each in report["objects"]:
        assert added(amounts(copy) for copy in each["copies"]) == amounts(each), job.name
    assert all(amount >= 0 for part in parts for amount in part), job.name
    assert all(min(copy) > 0 for copy in copies), (job.name, "a copy has no time, filament or cost")


def labelled_filament(gcode):
    """Returns the extruded length in mm between the labels of each copy, as (object, copy), with relative E."""
    used, copy, e_at = collections.defaultdict(float), None, re.compile(r"\bE(-?[\d.]+)")
    for line in gcode.splitlines():
        if label := re.match(r"; (stop )?printing object .* id:(\d+) copy (\d+)", line):
            copy = None if label[1] else (int(label[2]), int(label[3]))
        elif copy and line.startswith("G") and (e := e_at.search(line.split(";")[0])):
            used[copy] += float(e[1])
    return used


def agrees_with_labels(report, gcode, job):
    used = labelled_filament(gcode)
    assert len(used) == sum(job.copies), (job.name, sorted(used))
    for (number, copy), mm in used.items():
        share = report["objects"][number]["copies"][copy]["filament"]["mm"]
        assert abs(share - mm) < max(0.02, 1e-4 * mm), (job.name, number, copy, share, mm)


def order_does_not_matter(program, folder, models):
    names = ["busted.stl", "textbox.stl", "thin_walls.stl"]
    seen = collections.defaultdict(set)
    for order in itertools.permutations(names):
        report = slice_models(program, folder, models, list(order))
        for each in report["objects"]:
            seen[each["name"]].add(amounts(each)[1:4])
    assert len(seen) == 3
    for name, filaments in seen.items():
        for column in zip(*filaments):
            assert max(column) - min(column) <= UNIT, (name, column)


def copies_are_alike(program, folder, models):
    slice_models(program, folder, models, ["busted.stl", "--copies", "busted.stl=30", "--plates", "--set", "bed_shape=0x0,70x0,70x70,0x70"], "many")
    reports = [json.loads(path.read_text()) for path in sorted(folder.glob("many-*.json"))]
    assert len(reports) > 1, "one bed is enough: the test needs a smaller one"
    for report in reports:
        parts = [amounts(copy) for each in report["objects"] for copy in each["copies"]] + [amounts(report["shared"])]
        assert added(parts) == total_of(report)
    copies = [amounts(copy)[1:4] for report in reports for each in report["objects"] for copy in each["copies"]]
    assert len(copies) == 30
    turned = {tuple(round(amount, 2) for amount in copy) for copy in copies}
    assert len(turned) <= 2, turned  # copies may be turned by 90 degrees


def farm_bills_the_same(program, folder, models):
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    job = JOBS[1]
    here = slice_models(program, folder, models, job.arguments)
    paths = [str(models / a) if a.endswith(".stl") else a for a in job.arguments]
    with running_farm() as farm:
        done = farm.client("submit", *paths, *COMMON[1:], "--detach")
        assert done.returncode == 0, done.stderr
        job_id = done.stdout.strip()
        assert farm.client("watch", job_id).returncode == 0
        told = json.loads(farm.client("get", job_id).stdout)
    result = told["result"]
    assert len(result["objects"]) == 3, result
    keys = ("time_s", "filament_mm", "filament_mm3", "filament_g")
    for each, local in zip(result["objects"], here["objects"]):
        assert each["name"] == local["name"]
        for copy, wanted in zip(each["copies"], local["copies"]):
            assert tuple(copy.get(key, 0) for key in keys) == amounts(wanted)[:4]
    parts = [copy for each in result["objects"] for copy in each["copies"]] + [result["shared"]]
    for key, total in zip(keys, ("print_time_s", "filament_mm", "filament_mm3", "filament_g")):
        assert sum(part.get(key, 0) for part in parts) == result[total], key
    cost = sum(part["cost"].get("total", 0) for part in parts)
    assert cost == result["cost"]["total"] and cost > 0, (cost, result["cost"])


def main():
    program, models = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for job in JOBS:
            report = slice_models(program, folder, models, job.arguments)
            adds_up(report, job)
            agrees_with_labels(report, (folder / "out.gcode").read_text(), job)
            print(f"{job.name}: {report['shared']['time_s']:.1f} s of {report['print_time_s']:.1f} s are shared")
        order_does_not_matter(program, folder, models)
        copies_are_alike(program, folder, models)
        farm_bills_the_same(program, folder, models)


main()
