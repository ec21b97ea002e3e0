#!/usr/bin/env python3
"""Slices a small cube with each machine of OrcaSlicer's or Bambu Studio's vendor files, as a project of these slicers.

usage: orca_profiles.py PROFILES_DIR SLICEFARM [--vendor NAME] [--limit N] [--keep DIR] [--filaments]

PROFILES_DIR is resources/profiles of their source. VENDOR.json lists presets, and
VENDOR/{machine,process,filament}/*.json contain them. The script processes each instantiated machine with nozzles. It
resolves the default process and filament, or else the first compatible ones, as OrcaSlicer does: a parent first, then
the preset's own keys over it. The result is put into a 3MF as project_settings.config and sliced. Machines whose
resolved settings differ only in names are run once. --filaments: also tries each filament's own G-code, each text once
per vendor, with the first machine that the filament names.
Rows: machines, distinct, broken (a parent is missing), no_process, no_filament, accepted, refused (of machines), then
each refusal with its count. Exit 0: none refused; 1: some refused, or none run; 2: usage.
"""
import argparse
import collections
import json
import os
import re
import subprocess
import sys
import tempfile
import zipfile

OF_FILES = {"type", "name", "inherits", "from", "instantiation", "setting_id", "filament_id", "include", "version", "is_custom_defined",
            "compatible_printers", "compatible_printers_condition", "compatible_prints", "compatible_prints_condition", "description"}
LIBRARY = "OrcaFilamentLibrary"
BEDS = {"1": "Cool Plate", "2": "Engineering Plate", "3": "High Temp Plate", "4": "Textured PEI Plate"}


def read_json(path):
    with open(path, encoding="utf-8-sig", errors="replace") as file:
        return json.load(file, strict=False)


class Vendor:
    """Presets of one vendor by kind and name; filaments may inherit from presets of a library that all vendors share."""

    def __init__(self, directory, name, library=None):
        self.name, self.library = name, library
        self.presets = {kind: {} for kind in ("machine", "process", "filament")}
        for kind, presets in self.presets.items():
            for root, _, files in os.walk(os.path.join(directory, name, kind)):
                for file in sorted(files):
                    if file.endswith(".json"):
                        preset = read_json(os.path.join(root, file))
                        presets[preset.get("name", file[:-5])] = preset

    def resolved(self, kind, name):
        preset = self.presets[kind].get(name)
        if preset is None and self.library and self.library is not self:
            return self.library.resolved(kind, name)
        if preset is None:
            raise LookupError(f"{kind} {name}")
        parent = preset.get("inherits")
        return {**(self.resolved(kind, parent) if parent else {}), **preset}

    def of_machine(self, kind, machine, wanted):
        """Returns the first preset of `wanted` that is compatible with the machine, else the first compatible preset of
        the vendor; None if there is none.
        """
        for name in wanted:
            if name in self.presets[kind] or (self.library and name in self.library.presets[kind]):
                whole = self.resolved(kind, name)
                if machine in (whole.get("compatible_printers") or [machine]):  # an empty list means all printers
                    return whole
        for name, preset in self.presets[kind].items():
            if preset.get("instantiation") != "true":
                continue
            try:
                whole = self.resolved(kind, name)
            except LookupError:
                continue  # a broken preset, which OrcaSlicer hides
            if machine in (whole.get("compatible_printers") or [machine][:self.name == LIBRARY]):
                return whole
        return self.library.of_machine(kind, machine, []) if self.library else None


    def by_gcode(self, machine, seen):
        """Yields the filaments made for the machine whose own G-code is not in `seen`, and adds this G-code to `seen`."""
        for name, preset in self.presets["filament"].items():
            if preset.get("instantiation") != "true":
                continue
            try:
                whole = self.resolved("filament", name)
            except LookupError:
                continue
            gcode = json.dumps([whole.get(key) for key in ("filament_start_gcode", "filament_end_gcode")])
            if machine in as_list(whole.get("compatible_printers")) and gcode not in seen:
                seen.add(gcode)
                yield whole


def as_list(value):
    values = value if isinstance(value, list) else str(value or "").split(";")
    return [item for item in values if item]


def settings_of(presets, bed):
    """Returns one flat set of settings as in a project; a filament's value is a list with an item for each filament.
    Every project states the bed in the printer and the timelapse mode. No vendor's file has these settings, and some
    vendors' files lack further ones.
    """
    settings = {"curr_bed_type": bed, "timelapse_type": "0", "enable_pressure_advance": ["0"]}
    for kind, preset in presets:
        for key, value in preset.items():
            if key not in OF_FILES:
                settings[key] = value if isinstance(value, list) or kind != "filament" else [value]
    for kind, preset in presets:
        name = {"machine": "printer", "process": "print"}.get(kind, kind) + "_settings_id"
        settings[name] = [preset["name"]] if kind == "filament" else preset["name"]
    return settings


def centre_of(area):
    points = [tuple(map(float, point.split("x"))) for point in ",".join(area).split(",") if point] or [(0.0, 0.0), (200.0, 200.0)]
    return [(min(axis) + max(axis)) / 2 for axis in zip(*points)]


def write_project(path, settings, size=10.0):
    x, y = centre_of(as_list(settings.get("printable_area", [])))
    corners = "".join(f'<vertex x="{i % 2 * size}" y="{i // 2 % 2 * size}" z="{i // 4 * size}"/>' for i in range(8))
    faces = (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces)
    model = ('<?xml version="1.0" encoding="UTF-8"?><model unit="millimeter" '
             'xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><metadata name="Application">BambuStudio-02.02.00.00'
             f'</metadata><resources><object id="1" type="model"><mesh><vertices>{corners}</vertices><triangles>{triangles}</triangles>'
             '</mesh></object></resources><build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 '
             f'{x - size / 2} {y - size / 2} 0"/></build></model>')
    rels = ('<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship '
            'Target="/3D/3dmodel.model" Id="rel-1" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>')
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("_rels/.rels", rels)
        archive.writestr("3D/3dmodel.model", model)
        archive.writestr("Metadata/project_settings.config", json.dumps(settings, indent=1))


def projects(directory, only, counts, each_filament=False):
    """Yields (vendor, machine, settings) of each machine; with `each_filament` also for each filament's own G-code."""
    names = sorted(name for name in os.listdir(directory) if os.path.isdir(os.path.join(directory, name, "machine")))
    library = Vendor(directory, LIBRARY) if os.path.isdir(os.path.join(directory, LIBRARY)) else None
    for name in names:
        if only and name != only:
            continue
        vendor = Vendor(directory, name, library)
        seen = set()
        for machine, preset in vendor.presets["machine"].items():
            if preset.get("type") != "machine" or preset.get("instantiation") != "true":
                continue
            counts["machines"] += 1
            try:
                whole = vendor.resolved("machine", machine)
                model = vendor.presets["machine"].get(whole.get("printer_model"), {})
                process = vendor.of_machine("process", machine, as_list(whole.get("default_print_profile")))
                filament = vendor.of_machine("filament", machine, as_list(whole.get("default_filament_profile")) +
                                             as_list(model.get("default_materials")))
            except LookupError as missing:
                counts["broken"] += 1
                print(f"# broken {name}/{machine}: {missing}", file=sys.stderr)
                continue
            counts["no_process"] += process is None
            counts["no_filament"] += filament is None
            parts = [("machine", whole), ("process", process), ("filament", filament)]
            bed = model.get("default_bed_type") or "Cool Plate"
            yield name, machine, settings_of([part for part in parts if part[1]], BEDS.get(bed, bed))
            for other in vendor.by_gcode(machine, seen) if each_filament else ():
                counts["filaments"] += 1
                yield name, f"{machine}, {other['name']}", settings_of(
                    [part for part in (*parts[:2], ("filament", other)) if part[1]], BEDS.get(bed, bed))


def reason_of(text):
    lines = [line for line in text.splitlines() if line.startswith("error")] or text.splitlines() or ["no message"]
    return re.sub(r"-?\d+(\.\d+)?", "N", lines[0])


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("directory")
    parser.add_argument("slicer")
    parser.add_argument("--vendor")
    parser.add_argument("--limit", type=int)
    parser.add_argument("--keep")
    parser.add_argument("--filaments", action="store_true")
    args = parser.parse_args()
    counts, groups = collections.Counter(), {}
    for vendor, machine, settings in projects(args.directory, args.vendor, counts, args.filaments):
        form = json.dumps({k: v for k, v in settings.items() if not re.search(r"_id$|_notes$|printer_model|thumbnail", k)}, sort_keys=True)
        groups.setdefault(form, []).append((vendor, machine, settings))
    counts["distinct"] = len(groups)
    reasons, examples = collections.Counter(), {}
    with tempfile.TemporaryDirectory() as scratch:
        for members in list(groups.values())[:args.limit]:
            vendor, machine, settings = members[0]
            name = re.sub(r"\W+", "_", f"{vendor} {machine}")
            project, gcode = (os.path.join(args.keep or scratch, name + ending) for ending in (".3mf", ".gcode"))
            write_project(project, settings)
            run = subprocess.run([args.slicer, "slice", project, "-o", gcode], capture_output=True, text=True, errors="replace")
            good = run.returncode == 0 and os.path.exists(gcode)
            counts["accepted" if good else "refused"] += len(members)
            if not good:
                reasons[reason_of(run.stderr)] += len(members)
                examples.setdefault(reason_of(run.stderr), f"{vendor}/{machine}")
            if not args.keep and os.path.exists(gcode):
                os.remove(gcode)
    for key in ("machines", "filaments", "distinct", "broken", "no_process", "no_filament", "accepted", "refused"):
        print(key, counts[key])
    for reason, number in reasons.most_common():
        print(f"refused {number} {reason} [{examples[reason]}]")
    return 0 if counts["accepted"] and not counts["refused"] else 1


if __name__ == "__main__":
    sys.exit(main())
