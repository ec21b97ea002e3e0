#!/usr/bin/env python3
"""Compares slicefarm's presets with PrusaSlicer's own result, for random jobs of a vendor's bundle.

usage: presets_peer.py BUNDLE.ini PRUSA_SLICER SLICEFARM FOLDER [--printers N] [--jobs N] [--seed N]

FOLDER is an empty folder for PrusaSlicer's data. For each of N random printers (of one tool), the processes and filaments that
PrusaSlicer 2.9 calls compatible (--query-print-filament-profiles) must be those of `slicefarm presets list`. For N random jobs of them the
values that it saves (--printer-profile, --print-profile, --material-profile, --save) must be those of `slicefarm presets show`; numbers
may be written differently. Prints `lists N equal N` and `jobs N equal N`, and the first differences. Exit 0: all are equal.
"""
import argparse
import collections
import json
import os
import random
import re
import shutil
import subprocess
import sys

IGNORED = {"inherits", "alias", "renamed_from", "printer_settings_id", "print_settings_id", "filament_settings_id", "physical_printer_settings_id",
           "compatible_printers", "compatible_printers_condition", "compatible_prints", "compatible_prints_condition"}

# Older writings that PrusaSlicer converts when it reads them.
MEANING = {"1": ("enabled", "octoprint"), "0": ("disabled",), "": ("0",)}


def install(bundle, folder):
    """Makes PrusaSlicer's data folder, with all models and filaments of the bundle."""
    os.makedirs(os.path.join(folder, "vendor"), exist_ok=True)
    shutil.copy(bundle, os.path.join(folder, "vendor"))
    vendor, models, filaments, printers, section = os.path.basename(bundle)[:-4], {}, [], {}, ""
    with open(bundle, encoding="utf-8-sig") as text:
        for line in text:
            if match := re.match(r"\[(.+)\]", line):
                section = match[1]
                if section.startswith("filament:") and section[9] != "*":
                    filaments.append(section[9:])
            elif section.startswith("printer_model:") and (match := re.match(r"variants\s*=\s*(.*)", line)):
                models[section[14:]] = [v.strip() for v in match[1].split(";")]
    with open(os.path.join(folder, "PrusaSlicer.ini"), "w", encoding="utf-8") as ini:
        ini.write("version = 2.9.2\n\n[vendor:%s]\n" % vendor)
        for model, variants in models.items():
            ini.write("model:%s = %s\n" % (model, ";".join('"%s"' % v for v in variants)))
        ini.write("\n[filaments]\n" + "".join(f"{name} = 1\n" for name in filaments))


def plain(value):
    """The value without differences of writing."""
    parts = [part.strip() for part in re.split(r"[,;]", value.strip().strip('"'))]
    def number(part):
        match = re.fullmatch(r"(-?\d*\.?\d+)(%?)", part)
        return f"{float(match[1]):.6g}{match[2]}" if match else part.strip('"')
    return [number(part) for part in parts]


def same(ours, theirs):
    if ours == theirs or theirs in MEANING.get(ours, ()):
        return True
    ours, theirs = plain(ours.replace("%", "")), plain(theirs.replace("%", ""))
    # One value stands for each tool; a list of one item for all.
    return ours == theirs or (len(set(theirs)) == 1 and ours[:1] == theirs[:1]) or ours[: len(theirs)] == theirs


def run(command):
    return subprocess.run(command, capture_output=True, text=True)


def main():
    parser = argparse.ArgumentParser()
    for name in ("bundle", "prusa_slicer", "slicefarm", "folder"):
        parser.add_argument(name)
    parser.add_argument("--printers", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    install(options.bundle, options.folder)
    peer = [options.prusa_slicer, "--datadir", options.folder]
    ours = [options.slicefarm, "presets"]
    out = os.path.join(options.folder, "out")
    run(peer + ["--query-printer-models", "--output", out + ".json"])
    with open(out + ".json", encoding="utf-8") as text:
        models = json.load(text)["printer_models"]
    names = [p["name"] for m in models if m["technology"] == "FFF" for v in m["variants"] for p in v["printer_profiles"]
             if p.get("extruders_cnt", 1) == 1]
    rng = random.Random(options.seed)
    lists, jobs, count = 0, [], collections.Counter()
    for printer in rng.sample(names, min(options.printers, len(names))):
        run(peer + ["--printer-profile", printer, "--query-print-filament-profiles", "--output", out + ".json"])
        with open(out + ".json", encoding="utf-8") as text:
            theirs = json.load(text)["print_profiles"]
        listed = json.loads(run(ours + ["list", "--json", "--presets", options.bundle, "--printer", printer]).stdout)
        mine = {kind: {p["name"] for p in listed if p["kind"] == kind} for kind in ("process", "filament")}
        processes = {p["name"] for p in theirs}
        filaments = {f for p in theirs for f in p["filament_profiles"]}
        count["lists"] += 1
        equal = mine["process"] == processes and filaments <= mine["filament"]
        count["lists equal"] += equal
        if not equal:
            print(f"{printer}: processes {sorted(mine['process'] ^ processes)[:3]}, filaments {sorted(filaments - mine['filament'])[:3]}")
        jobs += [(printer, p["name"], f) for p in theirs for f in p["filament_profiles"]]
    different = collections.Counter()
    for printer, process, filament in rng.sample(jobs, min(options.jobs, len(jobs))):
        run(peer + ["--printer-profile", printer, "--print-profile", process, "--material-profile", filament, "--save", out + ".ini"])
        shown = json.loads(run(ours + ["show", "--json", "--presets", options.bundle, "--printer", printer, "--process", process,
                                       "--filament", filament]).stdout)["settings"]
        with open(out + ".ini", encoding="utf-8") as text:
            theirs = dict(line.rstrip("\n").split(" = ", 1) for line in text if " = " in line)
        wrong = [key for key, value in shown.items() if key in theirs and key not in IGNORED and not same(value["value"], theirs[key])]
        count["jobs"] += 1
        count["jobs equal"] += not wrong
        count["values"] += sum(key in theirs for key in shown)
        for key in wrong:
            different[f"{key}: {shown[key]['value'][:50]!r}, PrusaSlicer has {theirs[key][:50]!r}"] += 1
        os.remove(out + ".ini")
    for line, times in different.most_common(20):
        print(times, line)
    print(f"lists {count['lists']} equal {count['lists equal']}, jobs {count['jobs']} equal {count['jobs equal']}, values {count['values']}")
    return 0 if count["jobs"] and count["jobs"] == count["jobs equal"] and count["lists"] == count["lists equal"] else 1


if __name__ == "__main__":
    sys.exit(main())
