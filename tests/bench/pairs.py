#!/usr/bin/env python3
"""Compares the CPU time of two slicefarm programs by stage: see guard.sh."""
import argparse
import json
import os
import subprocess
import sys
import tempfile

STAGES = ("slicing", "planning", "beading", "infill", "ordering", "motion")


def slice_once(program, model, directory):
    """Returns the CPU seconds of one run: whole program ("all") and each stage, with one thread."""
    report = os.path.join(directory, "report.json")
    command = [program, "slice", model, "-o", os.path.join(directory, "out.gcode"), "--report", report,
               "--threads", "1", "--generic"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{' '.join(command)}: {errors.decode(errors='replace')}")
    with open(report, encoding="utf-8") as file:
        stages = json.load(file)["stage_times_s"]
    return {"all": usage.ru_utime + usage.ru_stime, **{stage: stages[stage] for stage in STAGES}}


def least(times):
    """Returns the least time of each key over all runs."""
    return {key: min(run[key] for run in times) for key in times[0]}


def row(name, base, tree):
    """Returns a row: CPU time of both programs, their ratio, and the ratio of each stage that takes more than a
    hundredth of the total.
    """
    cells = [f"{name:16s} {base['all']:7.3f} {tree['all']:7.3f} {tree['all'] / base['all']:6.3f}"]
    for stage in STAGES:
        counts = base[stage] > 0.01 * base["all"]
        cells.append(f"{tree[stage] / base[stage]:8.3f}" if counts else f"{'-':>8s}")
    return " ".join(cells)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("baseline")
    parser.add_argument("tree")
    parser.add_argument("models", nargs="+")
    parser.add_argument("--runs", type=int, default=4)
    parser.add_argument("--limit", type=float, default=1.05)
    args = parser.parse_args()
    print(f"{'model':16s} {'base_s':>7s} {'tree_s':>7s} {'ratio':>6s} " + " ".join(f"{s:>8s}" for s in STAGES))
    sums = [dict.fromkeys(("all",) + STAGES, 0.0) for _ in range(2)]
    with tempfile.TemporaryDirectory() as directory:
        for model in args.models:
            runs = ([], [])
            for _ in range(args.runs):
                for side, program in enumerate((args.baseline, args.tree)):
                    runs[side].append(slice_once(program, model, directory))
            base, tree = least(runs[0]), least(runs[1])
            print(row(os.path.splitext(os.path.basename(model))[0], base, tree), flush=True)
            for total, times in zip(sums, (base, tree)):
                for key in total:
                    total[key] += times[key]
    print(row("sum", *sums))
    ratio = sums[1]["all"] / sums[0]["all"]
    if ratio > args.limit:
        sys.exit(f"the tree takes {ratio:.3f} times the CPU of the baseline: more than {args.limit}")


if __name__ == "__main__":
    main()
