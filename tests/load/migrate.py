#!/usr/bin/env python3
"""Measures `slicefarm-coordinator migrate` on a working farm. Two coordinators use a database of a million ended jobs
without the indexes that a later build adds. Meanwhile a client submits one job after another.

    tests/load/migrate.py [--rows 1000000] [--seconds 20]

Prints `key value` rows:
  rows; steps: number of steps taken; migrate_s;
  jobs: jobs that ended during the migration; failed: failures among them;
  submit_p99_ms and job_p99_s: before and during the migration;
  longest_pause_s: longest time without the end of a job during the migration.
The exit code is 1 if a job failed or if no job ended for a minute. SLICEFARM_BIN: directory of the programs (default
build/bin).
"""
import argparse
import pathlib
import subprocess
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from exhaust_rows import FILL, sql
from local_farm import BIN, MODELS, percentile, running_farm

# Steps and their indexes.
STEPS = {"0009_held_work": "jobs_held_work", "0012_events": "events_by_time"}


class Client(threading.Thread):
    """Submits a job and waits for its end, repeatedly."""

    def __init__(self, farm):
        super().__init__()
        self.farm, self.ended, self.number = farm, threading.Event(), 0
        self.jobs = []  # (time of submission, its duration, time of the end, success)
        self.start()

    def run(self):
        while not self.ended.is_set():
            self.number += 1
            begun = time.monotonic()
            job = self.farm.submit(MODELS / "textbox.stl", "--set", f"infill_speed={40 + self.number * 0.001:.3f}")
            submitted = time.monotonic()
            done = self.farm.client("watch", job)
            self.jobs.append((begun, submitted - begun, time.monotonic(), done.returncode == 0))

    def stop(self):
        self.ended.set()
        self.join()

    def between(self, begin, end):
        return [job for job in self.jobs if begin <= job[2] <= end]


def rows_of(jobs, name):
    yield f"submit_p99_ms_{name}", round(1000 * percentile([job[1] for job in jobs], 0.99), 1)
    yield f"job_p99_s_{name}", round(percentile([job[2] - job[0] for job in jobs], 0.99), 3)


def longest_pause_s(jobs, begin, end):
    times = [begin, *(job[2] for job in jobs), end]
    return max(b - a for a, b in zip(times, times[1:]))


def measure(options):
    with running_farm("postgres") as farm:
        sql(farm, FILL % options.rows)
        sql(farm, "VACUUM ANALYZE")
        for step, index in STEPS.items():
            sql(farm, f"DROP INDEX {index}")
            sql(farm, f"DELETE FROM slicefarm_migrations WHERE name = '{step}'")
        client = Client(farm)
        try:
            time.sleep(options.seconds)  # warm-up
            begin = time.monotonic()
            command = [BIN / "slicefarm-coordinator", "migrate", "--postgres", farm.postgres.connection]
            steps = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout.split()
            end = time.monotonic()
        finally:
            client.stop()
        assert steps == list(STEPS), steps
        meanwhile = client.between(begin, end)
        failed = sum(not job[3] for job in meanwhile)
        pause_s = longest_pause_s(meanwhile, begin, end)
        yield from [("rows", options.rows), ("steps", len(steps)), ("migrate_s", round(end - begin, 1)), ("jobs", len(meanwhile)), ("failed", failed)]
        yield from rows_of(client.between(0, begin)[1:], "before")
        yield from rows_of(meanwhile, "meanwhile")
        yield "longest_pause_s", round(pause_s, 2)
        return failed == 0 and pause_s < 60


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, default=1_000_000)
    parser.add_argument("--seconds", type=float, default=20, help="before the migration")
    rows = measure(parser.parse_args())
    while True:
        try:
            print(*next(rows), flush=True)
        except StopIteration as end:
            return 0 if end.value else 1


if __name__ == "__main__":
    sys.exit(main())
