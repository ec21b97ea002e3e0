#!/usr/bin/python3
"""Measures how long calls, metrics and health checks take while PostgreSQL is paused, and how long the farm takes to
recover. Run it with Debian's python3, which has Debian's grpc.

usage: standstill.py [SECONDS]      length of the pause (100)
"""
import pathlib
import subprocess
import sys
import threading
import time
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import grpc
from local_farm import BIN, MODELS, ROOT, running_farm

READS = ("GetJob", "ListJobs", "GetUsage", "GetCaller")


class Times:
    """Repeats a call until it is stopped, and records the time and the outcome of each."""

    def __init__(self, name, work, pause_s=1.0):
        self.name, self.work, self.pause_s, self.times, self.ends = name, work, pause_s, [], {}
        self.ended = threading.Event()
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        while not self.ended.is_set():
            begin = time.monotonic()
            end = self.work()
            self.times.append(time.monotonic() - begin)
            self.ends[end] = self.ends.get(end, 0) + 1
            self.ended.wait(self.pause_s)

    def stop(self):
        self.ended.set()
        self.thread.join()
        print(f"| {self.name} | {len(self.times)} | {max(self.times):.1f} | {self.ends} |", flush=True)


def call(channel, method, request=b""):
    def make():
        try:
            channel.unary_unary(f"/slicefarm.v1.Jobs/{method}")(request, timeout=120)
            return "OK"
        except grpc.RpcError as error:
            return error.code().name
    return make


def page(service, path):
    def get():
        with urllib.request.urlopen(f"http://127.0.0.1:{service.metrics_port}{path}", timeout=120) as answer:
            text = answer.read().decode()
        return "store_up 0" if "slicefarm_store_up 0" in text else "store_up 1" if "slicefarm_store_up 1" in text else "answered"
    return get


def health(service, *more):
    def ask():
        run = subprocess.run([BIN / "slicefarm", "health", service.address, *more], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return f"exit code {run.returncode}"
    return ask


def create(service, number):
    """Returns a function that submits a job with a request_id, as the command line does."""
    def make():
        run = subprocess.run([BIN / "slicefarm", "submit", MODELS / "textbox.stl", "--generic", "--detach", "-q", "--server", service.address,
                              "--patience", "0.1", "--set", f"fill_density={number}"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        return f"exit code {run.returncode}"
    return make


def main():
    still_s = float(sys.argv[1]) if len(sys.argv) > 1 else 100
    with running_farm("postgres") as farm:
        coordinator = farm.coordinators[0]
        job = farm.submit(MODELS / "textbox.stl", coordinator=coordinator)
        farm.await_end()
        channel = grpc.insecure_channel(coordinator.address)
        by_id = b"\x0a" + bytes([len(job)]) + job.encode()
        print("| what | times | longest, s | ends |\n|---|---|---|---|", flush=True)
        farm.postgres.run("pause")
        asking = [Times(method, call(channel, method, by_id if method == "GetJob" else b"")) for method in READS]
        asking += [Times(f"submit {i}", create(coordinator, 10 + i)) for i in range(12)]  # more jobs than database connections
        asking += [Times("/metrics", page(coordinator, "/metrics")), Times("/statusz", page(coordinator, "/statusz")),
                   Times("health", health(coordinator)), Times("health --live", health(coordinator, "--live"))]
        time.sleep(still_s)
        farm.postgres.run("resume")
        begin = time.monotonic()
        for each in asking:
            each.stop()
        while health(coordinator)() != "exit code 0":
            time.sleep(0.1)
        farm.submit(MODELS / "textbox.stl", "--set", "fill_density=77", coordinator=coordinator)
        print(f"well again after {time.monotonic() - begin:.1f} s")


if __name__ == "__main__":
    main()
