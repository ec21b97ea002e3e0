#!/usr/bin/env python3
"""Measures the recovery time of a farm after a process was killed, and the repeated work: `key value` rows.

  tests/load/recovery.py [--kills 20] [--seed S] [worker] [coordinator] [takeover] [postgres] [calls] [rework]

worker, coordinator, postgres   the only process of its kind is killed and restarted at once: seconds until the next
                                range is finished, after which work continues
takeover    one of two coordinators on PostgreSQL is killed while it runs a job, and stays away: seconds until the
            other one has finished a range of this job
calls       errors of unary calls while workers are killed; the clients have the delivered service config
rework      CPU time of all processes for the same jobs with a kill every 10 s, relative to no kills
"""
import argparse
import pathlib
import random
import resource
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import MODELS, Progress, percentile, running_farm  # noqa: E402

MODEL = MODELS / "benchy.stl"
PATIENCE_S = 60
REWORK_JOBS = 160
REWORK_PAUSE_S = 10
CALLS_S = 30


def another_job(farm, number, coordinator=None):
    settings = ["--set", "layer_height=0.06", "--set", f"infill_speed={40 + number * 0.01:.2f}"]
    return farm.submit(MODEL, *settings, coordinator=coordinator)


class Backlog(threading.Thread):
    """Keeps a few jobs waiting."""

    def __init__(self, farm, most=3):
        super().__init__()
        self.farm, self.most, self.ended, self.number = farm, most, threading.Event(), 0

    def run(self):
        while not self.ended.wait(0.2):
            waiting = max(c.metric('slicefarm_jobs{state="QUEUED"}') or 0 for c in self.farm.coordinators)
            if waiting < self.most:
                another_job(self.farm, self.number)
                self.number += 1

    def stop(self):
        self.ended.set()
        self.join()


def seconds_to_next_range(store, victim, options, **farm_options):
    """Returns the recovery time of each kill."""
    took = []
    rng = random.Random(options.seed)
    with running_farm(store, **farm_options) as farm:
        backlog, progress = Backlog(farm), Progress(farm.coordinators)
        backlog.start()
        try:
            for _ in range(options.kills):
                begun = time.monotonic()
                while progress.recovery_s(begun) is None:
                    time.sleep(0.05)
                time.sleep(rng.uniform(0.2, 1.0))
                victim(farm).kill()
                killed = time.monotonic()
                victim(farm).start()
                while progress.recovery_s(killed) is None and time.monotonic() < killed + PATIENCE_S:
                    time.sleep(0.02)
                took.append(progress.recovery_s(killed) or PATIENCE_S)
        finally:
            backlog.stop()
            progress.stop()
    return took


def rows(name, took):
    yield f"{name}_kills", len(took)
    yield f"{name}_p50_s", f"{percentile(took, 0.5):.2f}"
    yield f"{name}_p99_s", f"{percentile(took, 0.99):.2f}"


def worker(options):
    return rows("worker", seconds_to_next_range("sqlite", lambda farm: farm.workers[0], options, workers=1))


def coordinator(options):
    return rows("coordinator", seconds_to_next_range("sqlite", lambda farm: farm.coordinators[0], options))


def postgres(options):
    return rows("postgres", seconds_to_next_range("postgres", lambda farm: farm.postgres, options))


def ranges_of(coordinator):
    return coordinator.metric('slicefarm_ranges_total{outcome="ok"}') or 0


def takeover(options):
    with running_farm("postgres", workers=1) as farm:
        took = [one_takeover(farm, number) for number in range(options.kills)]
    return rows("takeover", took)


def one_takeover(farm, number):
    """Runs a single job, so that the coordinator that finishes ranges is the one that runs the job."""
    before = {c.name: ranges_of(c) for c in farm.coordinators}
    another_job(farm, number)
    while not (running := [c for c in farm.coordinators if ranges_of(c) > before[c.name]]):
        time.sleep(0.005)
    other = next(c for c in farm.coordinators if c is not running[0])
    running[0].kill()
    killed = time.monotonic()
    while ranges_of(other) <= before[other.name] and time.monotonic() < killed + PATIENCE_S:
        time.sleep(0.01)
    took = time.monotonic() - killed
    running[0].start()
    farm.await_end()
    return took


def calls(options):
    rng = random.Random(options.seed)
    with running_farm() as farm:
        ended = threading.Event()

        def kill_workers():
            while not ended.wait(rng.uniform(0.5, 1.5)):
                victim = rng.choice(farm.workers)
                victim.kill()
                victim.start()

        killer = threading.Thread(target=kill_workers)
        killer.start()
        try:
            report = farm.load("--scenario", "print", "--rate", "10", "--seconds", str(CALLS_S))
        finally:
            ended.set()
            killer.join()
    yield "calls", sum(step["count"] for step in report["steps"].values())
    yield "calls_errors", sum(report["errorDistribution"].values())


def cpu_of_jobs(options, kills):
    """Returns the CPU time of all processes of a farm and its clients until the jobs have ended, and the number of
    kills."""
    rng = random.Random(options.seed)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done, ended = 0, threading.Event()
    with running_farm() as farm:

        def kill_one():
            nonlocal done
            while not ended.wait(REWORK_PAUSE_S):
                victim = rng.choice(farm.victims)
                victim.kill()
                victim.start()
                done += 1

        killer = threading.Thread(target=kill_one if kills else lambda: None)
        killer.start()
        try:
            for number in range(REWORK_JOBS):
                another_job(farm, number)
            jobs = farm.await_end()
        finally:
            ended.set()
            killer.join()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert all(job["state"] == "JOB_STATE_SUCCEEDED" for job in jobs)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, done


def rework(options):
    (without_s, _), (with_s, kills) = cpu_of_jobs(options, False), cpu_of_jobs(options, True)
    yield "rework_kills", kills
    yield "rework_cpu_without_s", f"{without_s:.1f}"
    yield "rework_cpu_with_s", f"{with_s:.1f}"
    yield "rework_percent", f"{100 * (with_s / without_s - 1):.1f}"


ROWS = {f.__name__: f for f in (worker, coordinator, takeover, postgres, calls, rework)}

if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="*", metavar="WHAT")
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    for what in arguments.what or ROWS:
        for key, value in ROWS[what](arguments):
            print(key, value, flush=True)
