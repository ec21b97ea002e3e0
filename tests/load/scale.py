#!/usr/bin/env python3
"""Measures the capacity of a farm: `key value` rows.

  tests/load/scale.py [submit] [get] [watch] [dispatch] [virtual] [two]      default: all

submit    durable CreateJob calls, 200 per second        get   GetJob calls, 500 per second
watch     1000 watchers of a job                         dispatch   CPU of the coordinator relative to the stages
virtual   64 workers that sleep 50 ms per layer: time of the layers relative to the time of the workers
two       a job on two workers with one slot each, relative to one worker; also only its distributed part
"""
import json
import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, running_farm  # noqa: E402

VIRTUAL_WORKERS = 64
LAYER_MS = 50
VIRTUAL_JOBS = 64
REPEATS = 5


def in_farm(measure, **farm_options):
    with running_farm(**farm_options) as farm:
        return measure(farm)


def milliseconds(report, percentile):
    return f"{report['percentiles'][percentile] / 1e6:.1f}"


def errors(report):
    return sum(report["errorDistribution"].values()) + report["skipped"]


def submit(farm):
    report = farm.load("--scenario", "submit", "--rate", "200", "--seconds", "30")
    yield "submit_per_s", f"{report['achieved_rps']:.0f}"
    yield "submit_p50_ms", milliseconds(report, "p50")
    yield "submit_p99_ms", milliseconds(report, "p99")
    yield "submit_errors", errors(report)


def get(farm):
    report = farm.load("--scenario", "get", "--rate", "500", "--seconds", "30")
    yield "get_per_s", f"{report['achieved_rps']:.0f}"
    yield "get_p99_ms", milliseconds(report, "p99")
    yield "get_errors", errors(report)


def watch(farm):
    report = farm.load("--scenario", "watch", "--watchers", "1000", "--closed", "1", "--seconds", "20")
    yield "watch_jobs", report["count"]
    yield "watch_events", report["events"]
    yield "watch_job_p99_ms", milliseconds(report, "p99")
    yield "watch_errors", errors(report)


def dispatch(farm):
    """Measures without the CPU time of the coordinator's start."""
    farm.await_end()
    coordinator_before, before = farm.coordinators[0].cpu_s(), sum(service.cpu_s() for service in farm.services)
    for number in range(4 * REPEATS):
        for model in ("benchy", "spot", "featuretype"):
            farm.submit(MODELS / f"{model}.stl", "--set", f"infill_speed={40 + number}")
    jobs = farm.await_end()
    coordinator = farm.coordinators[0].cpu_s() - coordinator_before
    stages = sum(service.cpu_s() for service in farm.services) - before - coordinator
    yield "dispatch_jobs", sum(job["state"] == "JOB_STATE_SUCCEEDED" for job in jobs)
    yield "dispatch_cpu_percent", f"{100 * coordinator / stages:.1f}"


def virtual():
    program = [BIN / "slicefarm-virtual-workers", "--count", str(VIRTUAL_WORKERS), "--layer-ms", str(LAYER_MS)]
    workers = subprocess.Popen(program, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        addresses = workers.stdout.readline().strip()
        yield from in_farm(lambda farm: list(fill(farm)), workers=0, extra=["--workers", addresses, "--jobs", "8"])
    finally:
        workers.terminate()
        workers.wait()


def fill(farm):
    """Runs jobs on workers that sleep for each layer. Measures from the first submission to the last end."""
    begin = time.time()
    for number in range(VIRTUAL_JOBS):
        farm.submit(MODELS / "benchy.stl", "--set", "layer_height=0.05", "--set", f"infill_speed={40 + number}")
    jobs = farm.await_end()
    seconds = time.time() - begin
    layers = sum(job["result"]["layers"] for job in jobs)
    yield "virtual_layers", layers
    yield "virtual_seconds", f"{seconds:.1f}"
    yield "virtual_efficiency_percent", f"{100 * layers * LAYER_MS / 1000 / (VIRTUAL_WORKERS * seconds):.1f}"


def job_seconds(farm):
    """Returns the shortest time of a part with many layers, from the call to the G-code. Also returns the shortest time
    of its ranges, from the first to the last."""
    took, ranges = [], []
    for number in range(REPEATS):
        begin = time.monotonic()
        done = farm.client("submit", MODELS / "featuretype.stl", "-q", "-o", farm.log / "out.gcode",
                           "--set", "layer_height=0.05", "--set", f"infill_speed={40 + number}")  # fmt: skip
        assert done.returncode == 0, done.stderr
        took.append(time.monotonic() - begin)
    for job in farm.jobs():
        trace = json.loads(farm.client("trace", job["id"]).stdout)
        ranges += [event["dur"] / 1e6 for event in trace["traceEvents"] if event["name"] == "ranges"]
    return min(took), min(ranges)


def two():
    (one_s, one_ranges_s), (two_s, two_ranges_s) = (in_farm(job_seconds, workers=count) for count in (1, 2))
    yield "one_worker_s", f"{one_s:.2f}"
    yield "two_workers_s", f"{two_s:.2f}"
    yield "two_workers_speedup", f"{one_s / two_s:.2f}"
    yield "two_workers_ranges_speedup", f"{one_ranges_s / two_ranges_s:.2f}"


ROWS = {
    "submit": lambda: in_farm(lambda farm: list(submit(farm))),
    "get": lambda: in_farm(lambda farm: list(get(farm))),
    "watch": lambda: in_farm(lambda farm: list(watch(farm))),
    "dispatch": lambda: in_farm(lambda farm: list(dispatch(farm))),
    "virtual": virtual,
    "two": two,
}

if __name__ == "__main__":
    for name in sys.argv[1:] or ROWS:
        for key, value in ROWS[name]():
            print(key, value, flush=True)
