#!/usr/bin/env python3
"""Fills in the G-code templates of vendors' profiles with slicefarm and with PrusaSlicer, and compares them line by
line.

usage: profiles_oracle.py SLICEFARM [PROFILES_DIR] [--slicer prusa-slicer] [--limit N] [--list]

Slices a cube of 10 mm with both slicers for each distinct set of templates of PrusaSlicer's installed bundles. Marks
enclose start_gcode, start_filament_gcode, before_layer_gcode, layer_gcode, end_filament_gcode and end_gcode. The text
between equal marks must be equal, except for lines that name known differences between the slicers (TOLD below). Exit
0: equal; 1: differences, listed; 77: no PrusaSlicer, or no profiles.
"""
import argparse
import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
from collections import Counter

KEYS = ("start_gcode", "start_filament_gcode", "before_layer_gcode", "layer_gcode", "end_filament_gcode", "end_gcode")
# Known differences in one template only: by key.
TOLD_OF = {"end_gcode": {r"\blayer_z\b": "PrusaSlicer's layer_z at the end counts the lift of the nozzle"}}
# Known differences between slicers in any template, with the printed reason.
TOLD = {
    r"print_time|_time\b": "times",
    r"used_filament|extruded_|total_weight|total_cost": "sums",
    r"first_layer_print_(min|max|size)|first_layer_print_convex_hull": "bounds of skirt and brim",
    r"timestamp|\b(year|month|day|hour|minute|second)\b": "clock",
    r"\brandom\b": "random numbers",
}


# Errors of PrusaSlicer for some profiles, and the settings that replace the refused ones.
ACCEPTED = {"First layer height": {"first_layer_height": "0.2"}, "Relative extruder": {"use_relative_e_distances": "0"}}


def read_bundle(path):
    sections, now = {}, None
    for line in open(path, encoding="utf-8", errors="replace"):
        line = line.strip()
        if line.startswith("[") and line.endswith("]"):
            now = sections.setdefault(line[1:-1], {})
        elif now is not None and "=" in line and not line.startswith(("#", ";")):
            key, value = line.split("=", 1)
            now[key.strip()] = value.strip()
    return sections


def names(text):
    return [a or b.strip() for a, b in re.findall(r'"((?:[^"\\]|\\.)*)"|([^;"]+)', text) if a or b.strip()]


def flat(sections, kind, name):
    own = sections[f"{kind}:{name}"]
    result = {}
    for parent in names(own.get("inherits", "")):
        result.update(flat(sections, kind, parent))
    result.update({k: v for k, v in own.items() if k != "inherits"})
    return result


def configs(directory):
    """Yields a config.ini for each printer whose default print and filament are in its bundle."""
    for file in sorted(os.listdir(directory)):
        if not file.endswith(".ini"):
            continue
        sections = read_bundle(os.path.join(directory, file))
        for section in sections:
            if not section.startswith("printer:") or section.startswith("printer:*"):
                continue
            try:
                printer = flat(sections, "printer", section[8:])
                parts = [flat(sections, kind, names(printer[f"default_{kind}_profile"])[0]) for kind in ("print", "filament")]
            except (KeyError, IndexError):
                continue
            if printer.get("printer_technology") == "SLA" or "," in printer.get("nozzle_diameter", "0.4"):
                continue
            config = {**parts[0], **parts[1], **printer}
            for key in [k for k in config if k.startswith("compatible_") or k in ("renamed_from", "alias", "family", "variants")]:
                del config[key]
            yield f"{file[:-4]}/{section[8:]}", config


def bare(value):
    """Returns a G-code text without the quotes of a one-element list."""
    if value.startswith('"') and value.endswith('"') and len(value) > 1:
        return re.sub(r'\\(["\\])', r"\1", value[1:-1])
    return value


def marked(config):
    result = dict(config)
    for key in KEYS:
        body = bare(config.get(key, ""))
        text = f";MARK {key}\\n{body}\\n;DONE {key}\\n"
        result[key] = '"' + text.replace('"', '\\"') + '"' if key.endswith("filament_gcode") else text
    return result


def blocks(gcode):
    found, now = {}, None
    for line in gcode.splitlines():
        line = line.rstrip()
        if line.startswith(";MARK "):
            now = (line[6:], [])
        elif line.startswith(";DONE ") and now:
            found.setdefault(now[0], []).append([l for l in now[1] if l and not re.match(r"M73 [PQ]", l)])  # without progress lines
            now = None
        elif now:
            now[1].append(line)
    return found


def same(a, b):
    """Returns true if two lines are equal, or differ only in numbers by at most one thousandth."""
    if a == b:
        return True
    number = r"-?\d*\.?\d+"
    if re.sub(number, "#", a) != re.sub(number, "#", b):
        return False
    return all(abs(float(x) - float(y)) <= 1e-3 * max(1, abs(float(x))) for x, y in zip(re.findall(number, a), re.findall(number, b)))


def cube(path):
    # Negative values give bytes over 127; without them PrusaSlicer reads the file as text.
    corner = [[10.0 * (i >> k & 1) - 5 for k in range(3)] for i in range(8)]
    faces = ((0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5))
    with open(path, "wb") as f:
        f.write(bytes(80) + struct.pack("<I", len(faces)))
        for face in faces:
            f.write(struct.pack("<12fH", 0, 0, 0, *(x for i in face for x in corner[i]), 0))


def run(command, out):
    r = subprocess.run(command, capture_output=True, text=True, errors="replace", timeout=300)
    if r.returncode != 0 or not os.path.exists(out):
        return None, (r.stderr or r.stdout).strip().splitlines()[:1]
    return open(out, encoding="utf-8", errors="replace").read(), None


def sliced_by(command, config, ini, out):
    with open(ini, "w", encoding="utf-8") as f:
        f.writelines(f"{k} = {v}\n" for k, v in sorted(marked(config).items()))
    result = run(command, out)
    if os.path.exists(out):
        os.remove(out)
    return result


def compare(ours, theirs, config):
    """Returns (different, told): unexpected differences as texts, and counts of known differences by reason."""
    different, told = [], Counter()
    for key in KEYS:
        a, b = ours.get(key, []), theirs.get(key, [])
        if key in ("before_layer_gcode", "layer_gcode"):
            a, b = a[:5], b[:5]
        patterns = {**TOLD, **TOLD_OF.get(key, {})}
        reasons = [why for pattern, why in patterns.items() if re.search(pattern, config.get(key, ""))]
        if len(a) != len(b):
            different.append(f"{key}: {len(a)} and {len(b)} times")
        for x, y in zip(a, b):
            lines = list(zip(x, y)) + [(l, None) for l in x[len(y):]] + [(None, l) for l in y[len(x):]]
            for left, right in lines:
                if left is not None and right is not None and same(left, right):
                    continue
                if reasons and left is not None and right is not None:
                    told[reasons[0]] += 1
                else:
                    different.append(f"{key}: {left!r} and {right!r}")
    return different, told


def main():
    p = argparse.ArgumentParser()
    p.add_argument("slicefarm")
    p.add_argument("profiles", nargs="?", default="/usr/share/PrusaSlicer/profiles")
    p.add_argument("--slicer", default="prusa-slicer")
    p.add_argument("--limit", type=int, default=0)
    p.add_argument("--list", action="store_true")
    o = p.parse_args()
    if not shutil.which(o.slicer) or not os.path.isdir(o.profiles):
        print("skipped: prusa-slicer is not installed, or has no profiles")
        return 77
    sets = {}
    for name, config in configs(o.profiles):
        sets.setdefault(tuple(config.get(k, "") for k in KEYS), (name, config))
    # Nested G-code with its marks cannot be separated.
    nested = re.compile(r"[\[{]\s*(" + "|".join(KEYS) + r")\b")
    all_sets = [each for each in sets.values() if not any(nested.search(each[1].get(k, "")) for k in KEYS)]
    told_sets = len(sets) - len(all_sets)
    chosen = all_sets[: o.limit or None]
    counts, told, bad, mended = Counter(), Counter(), [], []
    with tempfile.TemporaryDirectory() as work:
        model, ini, out = (os.path.join(work, n) for n in ("cube.stl", "c.ini", "o.gcode"))
        cube(model)
        for name, config in chosen:
            theirs, why = sliced_by([o.slicer, "-g", "--load", ini, model, "-o", out], config, ini, out)
            if theirs is None:
                mended.append(f"{name}: {' '.join(why)}")
                config = {**config, **next((other for what, other in ACCEPTED.items() if what in mended[-1]), {})}
                theirs, why = sliced_by([o.slicer, "-g", "--load", ini, model, "-o", out], config, ini, out)
            ours, why_not = sliced_by([o.slicefarm, "slice", model, "-o", out, "--config", ini, "-q"], config, ini, out)
            if ours is None or theirs is None:
                counts["ours_failed" if ours is None else "theirs_failed"] += 1
                bad.append(f"{name}: {why_not if ours is None else why}")
                continue
            different, said = compare(blocks(ours), blocks(theirs), config)
            told.update(said)
            counts["different" if different else "equal"] += 1
            bad += [f"{name}: {d}" for d in different[: 100 if o.list else 3]]
    print(f"sets {len(chosen)} " + " ".join(f"{k} {v}" for k, v in sorted(counts.items())))
    if told_sets:
        print(f"told templates within templates: {told_sets} sets left out")
    for text in mended:
        print(f"told what PrusaSlicer refuses is left out of {text}")
    for why, n in told.most_common():
        print(f"told {why}: {n} lines")
    print("\n".join(bad))
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
