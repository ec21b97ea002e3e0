#!/usr/bin/env python3
"""Checks that a farm stays stable: runs a mixed load for hours and measures the resources of its processes.

  tests/load/soak.py [--minutes 120] [--rate 4] [--store sqlite|postgres] [--seed S] [--csv FILE]

Prints `key value` rows: requests, errors, and for each process the megabytes at the end, their slopes and descriptors.
Slopes are in percent per hour with their standard errors. They begin when old blobs are removed as fast as new ones
arrive. One slope is of the means of every five minutes, which vary with huge parts. The other slope is of their
minima, which show the memory that remains when few jobs run. Descriptors are the medians of the two halves of this
time. Old jobs and blobs are removed during the run, as on a farm that runs for years.
"""
import argparse
import json
import math
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, percentile, running_farm  # noqa: E402

EVERY_S = 15
WINDOW_S = 300
KEPT_JOBS_DAYS = 0.01  # a quarter of an hour
KEPT_BLOBS_H = 1  # the smallest allowed value


class Watch(threading.Thread):
    """Rows of (seconds, process, MiB, descriptors)."""

    def __init__(self, farm):
        super().__init__()
        self.farm, self.rows, self.ended, self.begun = farm, [], threading.Event(), time.monotonic()

    def run(self):
        while not self.ended.wait(EVERY_S):
            now = time.monotonic() - self.begun
            self.rows += [(now, s.name, s.rss_mib(), s.descriptors()) for s in self.farm.services]

    def stop(self):
        self.ended.set()
        self.join()


def slope_percent_an_hour(points):
    """Returns the slope by least squares relative to the mean, and its standard error."""
    n = len(points)
    mean_t, mean_v = sum(t for t, _ in points) / n, sum(v for _, v in points) / n
    variance = sum((t - mean_t) ** 2 for t, _ in points)
    if n < 3 or variance == 0:
        return 0.0, float("inf")
    slope = sum((t - mean_t) * (v - mean_v) for t, v in points) / variance
    residuals = sum((v - mean_v - slope * (t - mean_t)) ** 2 for t, v in points)
    error = math.sqrt(residuals / (n - 2) / variance)
    return 100 * slope * 3600 / mean_v, 100 * error * 3600 / mean_v


def by_windows(points, summary):
    windows = {}
    for t, value in points:
        windows.setdefault(t // WINDOW_S, []).append(value)
    return [(window * WINDOW_S, summary(values)) for window, values in windows.items()]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=120)
    parser.add_argument("--rate", type=float, default=4)
    parser.add_argument("--store", choices=["sqlite", "postgres"], default="sqlite")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--csv", type=pathlib.Path)
    options = parser.parse_args()
    directory = pathlib.Path(tempfile.mkdtemp(prefix="slicefarm-soak-"))
    report = directory / "load.json"
    old = ["--keep-jobs", str(KEPT_JOBS_DAYS), "--keep-blobs", str(KEPT_BLOBS_H), "--sweep-after", "0"]
    with running_farm(options.store, directory, extra=old) as farm:
        watch = Watch(farm)
        try:
            watch.start()
            load = [BIN / "slicefarm-load", "--server", farm.coordinators[0].address, "--rate", str(options.rate)]
            load += ["--seconds", str(60 * options.minutes), "--mix", "mixed", "--seed", str(options.seed), "--json", report]
            subprocess.run(load, check=True, stdout=subprocess.DEVNULL)
        finally:
            watch.stop()
    if options.csv:
        options.csv.write_text("seconds,process,mib,descriptors\n" + "".join("%.0f,%s,%.1f,%d\n" % row for row in watch.rows))
    told = json.loads(report.read_text())
    errors = sum(told["errorDistribution"].values())
    print("requests", told["count"])
    print("errors", errors)
    for error, count in told["errorDistribution"].items():
        print(count, "x", error, file=sys.stderr)
    print("skipped", told["skipped"])
    settled = min(3600 * KEPT_BLOBS_H, 60 * options.minutes / 2)
    for name in dict.fromkeys(row[1] for row in watch.rows):
        late = [(t, mib, files) for t, process, mib, files in watch.rows if process == name and t > settled]
        memory = [(t, mib) for t, mib, _ in late]
        print(f"{name}_mib {late[-1][1]:.1f}")
        for key, summary in {"slope": statistics.mean, "least_slope": min}.items():
            slope, error = slope_percent_an_hour(by_windows(memory, summary))
            print(f"{name}_{key}_percent_h {slope:.2f}")
            print(f"{name}_{key}_error_percent_h {error:.2f}")
        half = len(late) // 2
        print(f"{name}_descriptors {percentile([f for *_, f in late[:half]], 0.5)} {percentile([f for *_, f in late[half:]], 0.5)}")
    shutil.rmtree(directory)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
