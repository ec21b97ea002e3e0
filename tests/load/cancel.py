#!/usr/bin/env python3
"""Measures how soon a cancelled job stops using the CPU: `key value` rows.

  tests/load/cancel.py [--jobs 60] [--seed S]

Cancels each job at a random moment of its run, and measures the CPU time of all services every 20 ms. A row gives the
seconds from the acknowledged cancel to the last interval that used more than half a core. An idle farm uses far less.
"""
import argparse
import pathlib
import random
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import MODELS, percentile, running_farm  # noqa: E402

EVERY_S = 0.02
LOOK_S = 2.0
IDLE_SHARE = 0.5  # fraction of a core


def busy_seconds(farm):
    """Returns the time from now to the last interval in which the farm was busy."""
    begun = last = time.monotonic()
    busy_until, cpu = begun, sum(s.cpu_s() for s in farm.services)
    while last < begun + LOOK_S:
        time.sleep(EVERY_S)
        now, total = time.monotonic(), sum(s.cpu_s() for s in farm.services)
        if total - cpu > IDLE_SHARE * (now - last):
            busy_until = now
        last, cpu = now, total
    return busy_until - begun


def cancel_one(farm, number, rng):
    model = MODELS / f"{rng.choice(['benchy', 'spot', 'featuretype'])}.stl"
    job = farm.submit(model, "--set", "layer_height=0.05", "--set", f"infill_speed={40 + number * 0.01:.2f}")
    while (farm.coordinators[0].metric('slicefarm_jobs{state="RUNNING"}') or 0) == 0:
        time.sleep(0.005)
    time.sleep(rng.uniform(0, 0.8))
    done = farm.client("cancel", job)
    if done.returncode != 0:
        return None  # the job had ended already
    return busy_seconds(farm)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    rng = random.Random(options.seed)
    with running_farm() as farm:
        took = [cancel_one(farm, number, rng) for number in range(options.jobs)]
        cancelled = sum(job["state"] == "JOB_STATE_CANCELLED" for job in farm.await_end())
    took = [seconds for seconds in took if seconds is not None]
    print("cancelled", cancelled)
    print("cancel_p50_s", f"{percentile(took, 0.5):.2f}")
    print("cancel_p99_s", f"{percentile(took, 0.99):.2f}")


if __name__ == "__main__":
    main()
