#!/usr/bin/env python3
"""Counts the settings of OrcaSlicer for prints with one tool that have an effect.

usage: orca_keys.py SLICEFARM [--list]

The settings and a value for each are in tests/corpus/config/orca_keys.txt: the options of presets in OrcaSlicer's Preset.cpp, without those
of hosts, profiles and several tools. A cube is sliced as a project with all of them; the report lists the settings without effect, or with
the nearest choice only. Prints `keys N act N` and, with --list, the others with their reasons. Exit 0: at least LEAST of them act.
"""
import json
import os
import re
import subprocess
import sys
import tempfile

from orca_profiles import write_project

KEYS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "corpus", "config", "orca_keys.txt")
LEAST = 493


def settings():
    values = {}
    with open(KEYS, encoding="utf-8") as lines:
        for line in lines:
            key, _, value = line.rstrip("\n").partition(" = ")
            values[key.removesuffix(" =")] = json.loads(value) if value.startswith("[") else value
    return values


def without_effect(slicefarm, values, folder):
    project, report = os.path.join(folder, "keys.3mf"), os.path.join(folder, "report.json")
    write_project(project, values)
    run = subprocess.run([slicefarm, "slice", project, "-o", os.path.join(folder, "keys.gcode"), "--report", report],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"the job was refused: {run.stderr}")
    with open(report, encoding="utf-8") as text:
        return json.load(text)["settings_without_effect"]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    values = settings()
    with tempfile.TemporaryDirectory() as folder:
        lines = without_effect(sys.argv[1], values, folder)
    idle = {}
    for line in lines:
        key = re.match(r"\w*", line)[0]
        if key in values:
            idle[key] = line
    print(f"keys {len(values)} act {len(values) - len(idle)}")
    if "--list" in sys.argv:
        for key in sorted(idle):
            print(idle[key])
    sys.exit(0 if len(values) - len(idle) >= LEAST else 1)


if __name__ == "__main__":
    main()
