#!/usr/bin/env python3
"""Compares `slicefarm presets show` with an independent resolver, for random jobs of real presets.

usage: preset_oracle.py SOURCE SLICEFARM [--jobs N] [--seed N] [--machines | --user FOLDER]

SOURCE is a folder of OrcaSlicer's or Bambu Studio's vendors (resources/profiles), or a vendor's .ini bundle of PrusaSlicer. Each job is a
random printer of OrcaSlicer with a random process and filament that name it, or one of PrusaSlicer with its defaults. All values that presets give must be equal, and no further key
may come from a preset. --machines: one job for each printer, with its default process and filament, instead of random ones.
--user: instead of jobs, at most N random presets that a user of OrcaSlicer made, from the JSON files in FOLDER. Their parents are in FOLDER or
in SOURCE. A preset whose parent is missing is refused, which does not count as a difference.

Prints a row `jobs N equal N refused N different N`, and the first differences. Exit 0: all jobs are equal, and there is at least one.
"""
import argparse
import itertools
import json
import os
import random
import re
import subprocess
import sys

LIBRARY = "OrcaFilamentLibrary"
NO_SETTINGS = {"type", "name", "inherits", "from", "instantiation", "setting_id", "include", "version", "description",
               "is_custom_defined", "renamed_from", "base_id", "user_id", "updated_time", "url", "alias"}
NOT_OF_JOBS = {"compatible_printers", "compatible_printers_condition", "compatible_prints", "compatible_prints_condition"}
ADDED = {"curr_bed_type", "printer_settings_id", "print_settings_id", "filament_settings_id"}
# Names and values of older versions that newer ones read.
RENAMED = {"bridge_fan_speed": "overhang_fan_speed", "chamber_temperatures": "chamber_temperature", "cooling": "slow_down_for_layer_cooling",
           "counterbole_hole_bridging": "counterbore_hole_bridging", "initial_layer_flow_ratio": "bottom_solid_infill_flow_ratio",
           "ironing_direction": "ironing_angle", "sparse_infill_anchor": "infill_anchor", "sparse_infill_anchor_max": "infill_anchor_max",
           "support_material_angle": "support_angle", "support_material_enforce_layers": "enforce_support_layers",
           "thumbnail_size": "thumbnails", "tool_change_gcode": "change_filament_gcode", "wall_infill_order": "wall_sequence",
           "wiping_volume": "prime_volume"}
NEW_VALUES = {("draft_shield", "limited"): "disabled", ("ensure_vertical_shell_thickness", "0"): "ensure_moderate",
              ("ensure_vertical_shell_thickness", "1"): "ensure_all", ("support_base_pattern", "none"): "hollow",
              ("support_type", "hybrid(auto)"): "tree(auto)", ("support_type", "normal"): "normal(manual)",
              ("support_type", "tree"): "tree(manual)", ("timelapse_type", "2"): "0"}
WALLS = {"infill/inner wall/outer wall": "inner wall/outer wall", "infill/outer wall/inner wall": "outer wall/inner wall",
         "inner wall/outer wall/infill": "inner wall/outer wall", "inner-outer-inner wall/infill": "inner-outer-inner wall",
         "outer wall/inner wall/infill": "outer wall/inner wall"}
KINDS = {"machine": "printer", "process": "process", "filament": "filament"}
ID_KEYS = {"printer_settings_id": "machine", "print_settings_id": "process", "filament_settings_id": "filament"}


def escaped(text):
    return text.replace("\\", "\\\\").replace("\r", "\\r").replace("\n", "\\n")


def orca_value(value):
    return json.dumps(value, ensure_ascii=False, separators=(",", ":")) if isinstance(value, list) else escaped(value)


def modern(preset):
    """The preset with the names and values of newer versions; of an old and a new name the new one counts."""
    new = {}
    for key, value in preset.items():
        key_now = RENAMED.get(key, key)
        if key_now != key and key_now in preset:
            continue
        if isinstance(value, str):
            value = NEW_VALUES.get((key_now, value), WALLS.get(value, value) if key_now == "wall_sequence" else value)
        new[key_now] = value
    return new


def valid(value):
    return isinstance(value, str) or isinstance(value, list) and all(isinstance(item, str) for item in value)


class Orca:
    """Presets of a folder of vendors: {vendor: {kind: {name: members}}}."""

    def __init__(self, folder):
        self.folder, self.vendors = folder, {}
        for file in sorted(os.listdir(folder)):
            if not file.endswith(".json"):
                continue
            with open(os.path.join(folder, file), encoding="utf-8-sig") as text:
                listed = json.load(text)
            if "machine_list" in listed:
                self.vendors[file[:-5]] = self.read(file[:-5], listed)

    def read(self, vendor, listed):
        presets = {kind: {} for kind in KINDS}
        for kind in KINDS:
            for item in listed.get(kind + "_list", []):
                try:
                    with open(os.path.join(self.folder, vendor, item["sub_path"]), encoding="utf-8-sig") as text:
                        preset = json.load(text)
                except (OSError, ValueError):
                    continue
                presets[kind].setdefault(preset["name"], preset)
        return presets

    def flat(self, vendor, kind, name):
        """All members, parents first. None: a parent is missing."""
        preset = self.vendors[vendor][kind].get(name)
        if preset is None and kind == "filament" and vendor != LIBRARY and LIBRARY in self.vendors:
            return self.flat(LIBRARY, kind, name)
        if preset is None:
            return None
        whole = {}
        for parent in filter(None, [preset.get("inherits"), *preset.get("include", [])]):
            above = self.flat(vendor, kind, parent)
            if above is None:
                return None
            whole.update(above)
        whole.update({key: value for key, value in modern(preset).items() if valid(value)})
        return whole

    def jobs(self, rng, count, machines):
        vendors = [v for v in self.vendors if self.vendors[v]["machine"]]
        printers = [(v, n) for v in vendors for n, p in self.vendors[v]["machine"].items() if p.get("instantiation") == "true"]
        for vendor, printer in printers if machines else (rng.choice(printers) for _ in range(20 * count)):
            machine = self.flat(vendor, "machine", printer)
            if machines:
                yield vendor, printer, "", ""
                continue
            fitting = {}
            for kind in ("process", "filament"):
                names = [n for n, p in self.vendors[vendor][kind].items() if p.get("instantiation") == "true"
                         and printer in (self.flat(vendor, kind, n) or {}).get("compatible_printers", [])]
                fitting[kind] = rng.choice(names) if names else ""
            prints = (self.flat(vendor, "filament", fitting["filament"]) or {}).get("compatible_prints")
            if machine and all(fitting.values()) and fitting["process"] in (prints or [fitting["process"]]):
                yield vendor, printer, fitting["process"], fitting["filament"]

    def sources(self, vendor):
        of = [vendor] + [LIBRARY] * (LIBRARY in self.vendors)
        return [os.path.join(self.folder, v + end) for v in dict.fromkeys(of) for end in (".json", "")
                if os.path.exists(os.path.join(self.folder, v + end))]

    def values(self, vendor, shown):
        """Key: the values that it may have. A key in presets of several kinds is the program's business."""
        found = {}
        for kind, name in KINDS.items():
            for key, value in (self.flat(vendor, kind, shown[name]["name"]) or {}).items():
                if key not in NO_SETTINGS | NOT_OF_JOBS:
                    found.setdefault(key, []).append(orca_value(value))
        return found


class User:
    """Presets of a user's folder: {kind: {name: [members, ...]}}. Parents that are not in it are vendors' presets."""

    def __init__(self, folder, orca):
        self.orca, self.presets = orca, {kind: {} for kind in KINDS}
        for root, folders, files in os.walk(folder):
            folders[:] = [name for name in folders if name != "system"]  # copies of the vendors' presets
            for file in sorted(files):
                if file.endswith(".json"):
                    self.read(os.path.join(root, file))

    def read(self, path):
        try:
            with open(path, encoding="utf-8-sig") as text:
                preset = json.load(text)
        except (OSError, ValueError):
            return
        if not isinstance(preset, dict) or not isinstance(preset.get("name"), str):
            return
        kind = preset.get("type") or next((kind for key, kind in ID_KEYS.items() if key in preset), None)
        if kind in KINDS:
            self.presets[kind].setdefault(preset["name"], []).append(preset)

    def made(self):
        """(kind, name) of the presets that the user made, with a name of their own."""
        return [(kind, name) for kind in KINDS for name, same in sorted(self.presets[kind].items())
                if name and len(same) == 1 and "inherits" in same[0] and same[0].get("instantiation") != "false"
                and same[0].get("from", "User").lower() != "system"
                and not any(name in vendor[kind] for vendor in self.orca.vendors.values())]

    def flats(self, kind, name, seen=()):
        """The whole presets that the name may mean: one for each vendor that has the parent. Empty: a parent is missing."""
        if name in self.presets[kind] and name not in seen:
            preset = self.presets[kind][name][0]
            parent = preset.get("inherits")
            above = self.flats(kind, parent, (*seen, name)) if parent else [{}]
            if not above and preset.get("is_custom_defined") == "1":
                above = [{}]  # OrcaSlicer writes all settings into such a preset
            own = {key: value for key, value in modern(preset).items() if valid(value)}
            return [{**whole, **own} for whole in above]
        wholes = [self.orca.flat(vendor, kind, now) for vendor, presets in self.orca.vendors.items()
                  for now, preset in presets[kind].items()
                  if preset.get("instantiation") == "true" and name in (now, *preset.get("renamed_from", "").split(";"))]
        return [whole for whole in wholes if whole is not None]


class Prusa:
    """Presets of one bundle: {kind: {name: members}}."""

    def __init__(self, path):
        self.path, self.presets = path, {"printer": {}, "print": {}, "filament": {}}
        section = None
        with open(path, encoding="utf-8-sig") as text:
            for line in text:
                line = line.strip()
                if match := re.fullmatch(r"\[(\w+):(.+)\]", line):
                    section = self.presets.get(match[1], {}).setdefault(match[2], {})
                elif line.startswith("["):
                    section = None
                elif section is not None and "=" in line and line[0] not in "#;":
                    key, value = line.split("=", 1)
                    section[key.strip()] = value.strip()

    def flat(self, kind, name):
        preset = self.presets[kind][name]
        whole = {}
        for parent in preset.get("inherits", "").split(";"):
            if parent.strip():
                whole.update(self.flat(kind, parent.strip().strip('"')))
        whole.update(preset)
        return whole

    def jobs(self, rng, count, machines):
        printers = [n for n in self.presets["printer"] if not n.startswith("*") and self.flat("printer", n).get("printer_technology") != "SLA"]
        for printer in printers if machines else (rng.choice(printers) for _ in range(20 * count)):
            yield None, printer, "", ""

    def sources(self, _vendor):
        return [self.path]

    def values(self, _vendor, shown):
        found = {}
        for kind, name in (("print", "process"), ("printer", "printer"), ("filament", "filament")):
            for key, value in self.flat(kind, shown[name]["name"]).items():
                if key not in {"inherits", "renamed_from", "alias"} | NOT_OF_JOBS:
                    found.setdefault(key, []).append(value)
        return found


def differences(expected, settings):
    for key, texts in expected.items():
        if key in ADDED:
            continue
        got = settings.get(key)
        if len(texts) > 1 and (got is None or got["value"] in texts):
            continue
        if got is None or got["preset"] == "default":
            yield f"{key}: missing, expected {texts[0][:60]}"
        elif got["value"] not in texts:
            yield f"{key}: {got['value'][:60]}, expected {texts[0][:60]}"
    for key, got in settings.items():
        if key not in expected and key not in ADDED and got["preset"] != "default":
            yield f"{key}: {got['value'][:60]}, expected none"


def compare_users(options, orca):
    user = User(options.user, orca)
    made = user.made()
    random.Random(options.seed).shuffle(made)
    count = {"presets": 0, "equal": 0, "refused": 0, "different": 0}
    for kind, name in made[:options.jobs]:
        run = subprocess.run([options.slicefarm, "presets", "show", name, "--json", "--presets", options.source, "--presets", options.user],
                             capture_output=True, text=True)
        wholes = user.flats(kind, name)
        count["presets"] += 1
        if run.returncode != 0:
            count["refused" if not wholes else "different"] += 1
            print(f"refused {kind} {name}: {run.stderr.strip()[:300]}")
            continue
        shown = next(preset for preset in json.loads(run.stdout) if preset["kind"] == KINDS[kind])
        settings = {key: got for key, got in shown["settings"].items() if key not in NOT_OF_JOBS}
        ways = [list(differences({key: [orca_value(value)] for key, value in whole.items() if key not in NO_SETTINGS | NOT_OF_JOBS}, settings))
                for whole in wholes]
        found = min(ways, key=len) if ways else ["resolves, although a parent is missing"]
        count["different" if found else "equal"] += 1
        for line in found[:5]:
            print(f"{kind} {name}: {line}")
    print(" ".join(f"{key} {value}" for key, value in count.items()))
    return 0 if count["equal"] and not count["different"] else 1


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("source")
    parser.add_argument("slicefarm")
    parser.add_argument("--jobs", type=int, default=50)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--machines", action="store_true")
    parser.add_argument("--user")
    options = parser.parse_args()
    if options.user:
        return compare_users(options, Orca(options.source))
    resolver = Prusa(options.source) if options.source.endswith(".ini") else Orca(options.source)
    count = {"jobs": 0, "equal": 0, "refused": 0, "different": 0}
    jobs = resolver.jobs(random.Random(options.seed), options.jobs, options.machines)
    for vendor, printer, process, filament in itertools.islice(jobs, None if options.machines else options.jobs):
        command = [options.slicefarm, "presets", "show", "--json", "--printer", printer]
        command += ["--process", process] * bool(process) + ["--filament", filament] * bool(filament)
        for source in resolver.sources(vendor):
            command += ["--presets", source]
        run = subprocess.run(command, capture_output=True, text=True)
        count["jobs"] += 1
        if run.returncode != 0:
            count["refused"] += 1
            print(f"refused {vendor}, {printer}, {process}, {filament}: {run.stderr.strip()[:300]}")
            continue
        shown = json.loads(run.stdout)
        found = list(differences(resolver.values(vendor, shown), shown["settings"]))
        count["different" if found else "equal"] += 1
        for line in found[:5]:
            print(f"{printer}, {process}, {filament}: {line}")
    print(" ".join(f"{key} {value}" for key, value in count.items()))
    return 0 if count["jobs"] and count["jobs"] == count["equal"] else 1


if __name__ == "__main__":
    sys.exit(main())
