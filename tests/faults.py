#!/usr/bin/env python3
"""See faults.sh. The supervisor: starts every process, kills them with SIGKILL, starts them again."""
import argparse
import collections
import hashlib
import json
import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = pathlib.Path(os.environ.get("SLICEFARM_BIN", ROOT / "build/bin"))
MODEL = ROOT / "tests/corpus/models/textbox.stl"
PAUSE_S = 0.6  # between kills, on average
LEAD = 4  # jobs that wait or run while processes are killed: there is always work to lose
PATIENCE_S = 600  # for all jobs to end when nothing is killed any more


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Service:
    """A program, on the same address in every life."""

    def __init__(self, name, log, *arguments):
        self.name, self.log, self.port, self.metrics_port = name, log, free_port(), free_port()
        self.address = f"127.0.0.1:{self.port}"
        program = BIN / f"slicefarm-{name.split('-')[0]}"
        self.command = [program, "--listen", self.address, "--metrics-port", str(self.metrics_port), *arguments]
        self.process = None

    def start(self):
        with open(self.log / f"{self.name}.log", "ab") as log:
            self.process = subprocess.Popen(self.command, stdout=log, stderr=log, stdin=subprocess.DEVNULL)

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()

    def stop(self):
        self.process.terminate()
        self.process.wait()

    def metric(self, name):
        """Sum over its labels; None while the service is being started."""
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{self.metrics_port}/metrics", timeout=2) as page:
                lines = page.read().decode().splitlines()
        except OSError:
            return None
        return sum(float(line.split()[-1]) for line in lines if line.startswith(name))


class Postgres:
    name = "postgres"

    def __init__(self, directory):
        self.directory = directory
        self.start()

    def run(self, command):
        script = ROOT / "deploy/postgres/server.sh"
        return subprocess.run([script, command, self.directory], check=True, stdout=subprocess.PIPE, text=True).stdout.strip()

    def start(self):
        self.connection = self.run("start")

    def kill(self):
        self.run("kill")

    def stop(self):
        self.run("stop")


class Farm:
    def __init__(self, store, directory):
        self.log = directory / "log"
        self.log.mkdir()
        slicing, motion = Service("slicing", self.log), Service("motion", self.log)
        workers = [Service(f"worker-{i}", self.log, "--slots", "1") for i in (1, 2)]
        stages = ["--slicing", slicing.address, "--motion", motion.address, "--workers", ",".join(w.address for w in workers)]
        self.postgres = Postgres(directory / "postgres") if store == "postgres" else None
        if self.postgres:
            state = ["--postgres", self.postgres.connection]
        else:
            state = ["--state-dir", str(directory / "state")]
        self.coordinators = [
            Service(f"coordinator-{i}", self.log, "--name", f"coordinator-{i}", *state, *stages)
            for i in range(1, 3 if self.postgres else 2)
        ]
        self.services = [slicing, motion, *workers, *self.coordinators]
        for service in self.services:
            service.start()
        self.victims = [*self.services, *([self.postgres] if self.postgres else [])]

    def client(self, *arguments, coordinator=None):
        coordinator = coordinator or random.choice(self.coordinators)
        command = [BIN / "slicefarm", *arguments, "--server", coordinator.address, "--patience", "120"]
        return subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def has_work(self):
        open_jobs = [
            (c.metric('slicefarm_jobs{state="QUEUED"}') or 0) + (c.metric('slicefarm_jobs{state="RUNNING"}') or 0)
            for c in self.coordinators
        ]
        return max(open_jobs) > 0

    def jobs(self):
        listed = self.client("list", "--json", "--limit", "100000")
        if listed.returncode != 0:
            return None
        jobs = json.loads(listed.stdout)
        return jobs["jobs"] if isinstance(jobs, dict) else jobs

    def stop(self):
        for service in reversed(self.services):
            service.stop()
        if self.postgres:
            self.postgres.stop()


class Progress:
    """When ranges were finished, by looking again and again."""

    def __init__(self, coordinators):
        self.coordinators, self.times, self.ended = coordinators, [], threading.Event()
        self.thread = threading.Thread(target=self.run)
        self.thread.start()

    def run(self):
        last = {}
        while not self.ended.wait(0.02):
            for coordinator in self.coordinators:
                finished = coordinator.metric('slicefarm_ranges_total{outcome="ok"}') or 0
                if finished > last.get(coordinator.name, 0):
                    self.times.append(time.monotonic())
                last[coordinator.name] = finished

    def stop(self):
        self.ended.set()
        self.thread.join()

    def recovery_s(self, since):
        return next((t - since for t in self.times if t > since), None)


def settings_of(number):
    """Thin layers, so that there is work; and another job each time."""
    return ["--set", "layer_height=0.06", "--set", f"infill_speed={40 + number * 0.01:.2f}"]


def expected_digest(number, directory):
    out = directory / f"expected-{number}.gcode"
    subprocess.run([BIN / "slicefarm", "slice", MODEL, "-q", "-o", out, *settings_of(number)], check=True)
    digest = hashlib.sha256(out.read_bytes()).hexdigest()
    out.unlink()
    return digest


class Submitter(threading.Thread):
    """Submits jobs one after the other, each until it is acknowledged; not before it is let."""

    def __init__(self, farm, count):
        super().__init__()
        self.farm, self.count, self.acknowledged, self.refused = farm, count, {}, []
        self.let, self.allowed = threading.Semaphore(0), 0

    def allow(self, count):
        for _ in range(min(count, self.count) - self.allowed):
            self.let.release()
            self.allowed += 1

    def run(self):
        for number in range(self.count):
            self.let.acquire()
            done = self.farm.client("submit", MODEL, "--detach", "-q", "--label", f"number={number}", *settings_of(number))
            if done.returncode == 0:
                self.acknowledged[number] = done.stdout.strip()
            else:
                self.refused.append(done.stderr.strip())


def kill_at_random(farm, submitter, kills, rng):
    """Kills, and starts again at once. Returns what was killed when, while there was work."""
    killed = []
    for i in range(kills):
        submitter.allow(i * submitter.count // kills + LEAD)
        time.sleep(rng.expovariate(1 / PAUSE_S))
        victim = rng.choice(farm.victims)
        if farm.has_work():
            killed.append((victim.name, time.monotonic()))
        victim.kill()
        victim.start()
    submitter.allow(submitter.count)
    return killed


def await_end(farm):
    until = time.monotonic() + PATIENCE_S
    while time.monotonic() < until:
        jobs = farm.jobs()
        if jobs is not None and all(job["state"] not in ("JOB_STATE_QUEUED", "JOB_STATE_RUNNING") for job in jobs):
            return jobs
        time.sleep(0.5)
    return farm.jobs() or []


def judge(acknowledged, jobs, directory):
    by_id = {job["id"]: job for job in jobs}
    numbers = collections.Counter(job["labels"]["number"] for job in jobs)
    lost, differing = [], []
    for number, job_id in acknowledged.items():
        job = by_id.get(job_id)
        if job is None or job["state"] != "JOB_STATE_SUCCEEDED":
            lost.append((number, job_id, job and job.get("error", job["state"])))
        elif job["result"]["gcode_sha256"] != expected_digest(number, directory):
            differing.append((number, job_id))
    duplicated = sum(count - 1 for count in numbers.values())
    return lost, duplicated, differing


def percentile(values, part):
    values = sorted(values)
    return values[min(len(values) - 1, int(part * len(values)))] if values else 0.0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--jobs", type=int, default=50)
    parser.add_argument("--store", choices=["sqlite", "postgres"], default="sqlite")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    directory = pathlib.Path(tempfile.mkdtemp(prefix="slicefarm-faults-"))
    directory.chmod(0o755)  # PostgreSQL's user goes through it
    random.seed(options.seed)
    farm = Farm(options.store, directory)
    progress = Progress(farm.coordinators)
    submitter = Submitter(farm, options.jobs)
    try:
        submitter.start()
        killed = kill_at_random(farm, submitter, options.kills, random.Random(options.seed))
        submitter.join()
        jobs = await_end(farm)
    finally:
        progress.stop()
        farm.stop()
    lost, duplicated, differing = judge(submitter.acknowledged, jobs, directory)
    recoveries = collections.defaultdict(list)
    for name, since in killed:
        recovery = progress.recovery_s(since)
        if recovery is not None:
            recoveries[name.split("-")[0]].append(recovery)
    for key, value in [
        ("kills", options.kills),
        ("jobs", len(submitter.acknowledged)),
        ("refused", len(submitter.refused)),
        ("lost", len(lost)),
        ("duplicated", duplicated),
        ("differing", len(differing)),
        ("recover_p99_s", f"{percentile([r for each in recoveries.values() for r in each], 0.99):.2f}"),
        *((f"recover_{name}_p99_s", f"{percentile(each, 0.99):.2f}") for name, each in sorted(recoveries.items())),
    ]:
        print(key, value)
    bad = lost or duplicated or differing
    for what in [*lost, *differing, *submitter.refused]:
        print("seed", options.seed, what, file=sys.stderr)
    if bad:
        print("logs:", farm.log, file=sys.stderr)
    else:
        shutil.rmtree(directory)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
