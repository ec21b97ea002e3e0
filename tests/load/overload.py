#!/usr/bin/env python3
"""Measures a tenant that requests twice the capacity of the farm, and another tenant beside it: `key value` rows.

  tests/load/overload.py [--minutes 10] [--mix tiny|mixed]

peak          jobs per second of one tenant with 16 at once (closed loop), which is the capacity
goodput       jobs per second that end in time at a load of twice the peak (open loop)
refused       refused calls, and the number of refusals without a time to retry
rss           MiB of all services together after a minute of overload, and the maximum later
calm          99th percentile of the other tenant's jobs, two per second, from upload to download: alone, beside half
              the peak, and beside twice the peak
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, running_farm  # noqa: E402

OPEN_JOBS = 200  # per tenant; more jobs are refused
CALM_RATE = 2
SETTLED_S = 60
CALM_S = 150  # duration of the runs for comparison


def make_tenants(path):
    """Writes the file of tenants and returns their tokens."""
    tokens, tenants = {}, {}
    for name in ("flood", "calm"):
        made = subprocess.run([BIN / "slicefarm", "token"], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()
        tokens[name] = path.with_name(f"{name}.token")
        tokens[name].write_text(made[0])
        tenants[name] = {"tokens": [json.loads(made[1])], "max_open_jobs": OPEN_JOBS}
    path.write_text(json.dumps({"tenants": tenants}))
    return tokens


class Load(threading.Thread):
    """Run of slicefarm-load at the same time as other runs."""

    def __init__(self, farm, token, rate, seconds, options):
        super().__init__()
        self.farm, self.report = farm, None
        self.arguments = ["--token-file", token, "--rate", f"{rate:.2f}", "--seconds", str(seconds)]
        self.arguments += ["--mix", options.mix, "--in-flight", "2048"]
        self.start()

    def run(self):
        self.report = self.farm.load(*self.arguments)

    def told(self):
        self.join()
        return self.report


class Memory(threading.Thread):
    def __init__(self, farm):
        super().__init__()
        self.farm, self.ended, self.begun = farm, threading.Event(), time.monotonic()
        self.settled = self.most = 0
        self.start()

    def run(self):
        while not self.ended.wait(2):
            mib = sum(service.rss_mib() for service in self.farm.services)
            if time.monotonic() < self.begun + SETTLED_S:
                self.settled = mib
            self.most = max(self.most, mib)

    def stop(self):
        self.ended.set()
        self.join()


def p99_ms(report):
    return f"{report['percentiles']['p99'] / 1e6:.0f}"


def measure(farm, tokens, options):
    peak = farm.load("--token-file", tokens["flood"], "--closed", "16", "--seconds", "30", "--mix", options.mix)["achieved_rps"]
    yield "peak_per_s", f"{peak:.1f}"
    yield "calm_alone_p99_ms", p99_ms(Load(farm, tokens["calm"], CALM_RATE, CALM_S, options).told())
    half = Load(farm, tokens["flood"], peak / 2, CALM_S, options)
    yield "calm_beside_half_p99_ms", p99_ms(Load(farm, tokens["calm"], CALM_RATE, CALM_S, options).told())
    half.told()
    memory = Memory(farm)
    flood = Load(farm, tokens["flood"], 2 * peak, 60 * options.minutes, options)
    calm = Load(farm, tokens["calm"], CALM_RATE, 60 * options.minutes, options).told()
    report = flood.told()
    memory.stop()
    goodput = report["succeeded"] / (60 * options.minutes)
    refused = report["resource_exhausted"]
    yield "offered_per_s", f"{2 * peak:.1f}"
    yield "goodput_per_s", f"{goodput:.1f}"
    yield "goodput_percent_of_peak", f"{100 * goodput / peak:.1f}"
    yield "refused", sum(refused.values())
    yield "refused_without_retry_info", sum(refused.values()) - refused["with_retry_info"]
    yield "other_errors", sum(report["errorDistribution"].values()) - sum(refused.values())
    yield "skipped", report["skipped"]
    yield "rss_after_a_minute_mib", f"{memory.settled:.0f}"
    yield "rss_most_mib", f"{memory.most:.0f}"
    yield "calm_errors", sum(calm["errorDistribution"].values())
    yield "calm_beside_twice_p99_ms", p99_ms(calm)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--mix", choices=["tiny", "mixed"], default="mixed")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="slicefarm-overload-") as directory:
        tenants = pathlib.Path(directory) / "tenants.json"
        tokens = make_tenants(tenants)
        with running_farm(directory=directory, extra=["--tenants", str(tenants)]) as farm:
            for key, value in measure(farm, tokens, options):
                print(key, value, flush=True)


if __name__ == "__main__":
    main()
