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
import zipfile

KEYS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "corpus", "config", "orca_keys.txt")
LEAST = 443
# Settings that are read, but have no effect.
READ_ONLY = {"support_interface_loop_pattern": "support interfaces always have a loop"}
TYPES = ('<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" '
         'ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" '
         'ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>')
RELATIONS = ('<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship '
             'Target="/3D/3dmodel.model" Id="a" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
FACES = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]


def model():
    corners = "".join(f'<vertex x="{10 * (i & 1)}" y="{5 * (i & 2)}" z="{2.5 * (i & 4)}"/>' for i in range(8))
    faces = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in FACES)
    return ('<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><metadata '
            'name="Application">OrcaSlicer-2.3.1</metadata><resources><object id="1" type="model"><mesh><vertices>' + corners +
            "</vertices><triangles>" + faces + '</triangles></mesh></object></resources><build><item objectid="1" '
            'transform="1 0 0 0 1 0 0 0 1 100 100 0"/></build></model>')


def settings():
    values = {}
    with open(KEYS, encoding="utf-8") as lines:
        for line in lines:
            key, _, value = line.rstrip("\n").partition(" = ")
            values[key.removesuffix(" =")] = json.loads(value) if value.startswith("[") else value
    return values


def without_effect(slicefarm, values, folder):
    project, report = os.path.join(folder, "keys.3mf"), os.path.join(folder, "report.json")
    with zipfile.ZipFile(project, "w") as package:
        package.writestr("[Content_Types].xml", TYPES)
        package.writestr("_rels/.rels", RELATIONS)
        package.writestr("3D/3dmodel.model", model())
        package.writestr("Metadata/project_settings.config", json.dumps(values))
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
    idle = {key: why for key, why in READ_ONLY.items() if key in values}
    for line in lines:
        key = re.match(r"\w*", line)[0]
        if key in values:
            idle[key] = line
    print(f"keys {len(values)} act {len(values) - len(idle)}")
    if "--list" in sys.argv:
        for key in sorted(idle):
            print(f"{key}: {idle[key]}" if key in READ_ONLY else idle[key])
    sys.exit(0 if len(values) - len(idle) >= LEAST else 1)


if __name__ == "__main__":
    main()
