#!/usr/bin/env python3
"""Supervisor for faults.sh: starts all processes, kills them with SIGKILL, and restarts them."""
import argparse
import collections
import hashlib
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time

from local_farm import BIN, MODELS, Progress, percentile, running_farm

MODEL = MODELS / "textbox.stl"
PAUSE_S = 0.6  # average time between kills
LEAD = 4  # jobs that wait or run during the kills, so that there is always work to lose
LASERS = 4  # one of LASERS jobs is a laser job
MILLS = 6  # one of MILLS jobs is a milling job
ENGRAVES = 7  # one of ENGRAVES jobs is an engraving job
PRESETS = 3  # one of PRESETS other jobs names presets that the farm stores
BUNDLES = 4  # number of bundles of presets
S3_FAULTS = 0.02  # fraction of the bucket's answers
PATIENCE_S = 600  # for the end of all jobs after the last kill


def bundle(number):
    """Returns a bundle of PrusaSlicer. Each number gives other walls."""
    return f"""[print:thin]\nlayer_height = 0.06\nperimeters = {number + 1}\n[filament:PLA]\ntemperature = 210
[printer:P]\nnozzle_diameter = 0.4\nbed_shape = 0x0,200x0,200x200,0x200\ngcode_flavor = marlin2
"""


def presets_of(number):
    """Returns the number of the bundle that a job names, or None."""
    fdm = "--machine" not in settings_of(number)
    return number % BUNDLES + 1 if fdm and number % PRESETS == 0 else None


def import_presets(farm, number, directory):
    """Stores the presets of a job. A repeated import adds no revision. Returns False if the farm refuses it."""
    name = f"acme{presets_of(number)}"
    path = directory / f"{name}.ini"
    path.write_text(bundle(presets_of(number)))
    done = farm.client("presets", "import", path)
    return done.returncode == 0 and done.stdout.startswith(f"{name}@1:")


def settings_of(number):
    """Returns settings with thin layers, so that there is much work. Each number gives a different job."""
    if number % LASERS == LASERS - 1:
        return ["--machine", "laser", "--set", "layer_height=0.06", "--set", "output_format=cli", "--set", f"hatch_speed={400 + number * 0.01:.2f}"]
    if number % MILLS == MILLS - 2:
        return ["--machine", "mill", "--set", "cutter=cyl:2", "--set", "finish_stepover=0.5", "--set", f"feed={400 + number * 0.01:.2f}"]
    if number % ENGRAVES == ENGRAVES - 2:
        return ["--machine", "engrave", "--set", "output_format=csv", "--set", f"spacing={0.2 + number * 0.0001:.4f}"]
    return ["--set", "layer_height=0.06", "--set", f"infill_speed={40 + number * 0.01:.2f}"]


def model_of(number, directory):
    """Returns a surface for texture jobs, and a part for all other jobs."""
    if "engrave" not in settings_of(number):
        return MODEL
    surface = directory / "surface.obj"
    if not surface.exists():
        surface.write_text(roof())
    return surface


def roof(side=40):
    """Returns a bent square as OBJ, with `side` mm and `side` cells per side."""
    rows = range(side + 1)
    points = "".join(f"v {x} {y} {(x - side / 2) ** 2 / side}\n" for y in rows for x in rows)
    corner = lambda x, y: y * (side + 1) + x + 1
    cells = ((x, y) for y in range(side) for x in range(side))
    faces = "".join(
        f"f {corner(x, y)} {corner(x + 1, y)} {corner(x + 1, y + 1)}\nf {corner(x, y)} {corner(x + 1, y + 1)} {corner(x, y + 1)}\n" for x, y in cells
    )
    return points + faces


def expected_digest(number, directory):
    out = directory / f"expected-{number}.out"
    presets = ["--presets", directory / f"acme{presets_of(number)}.ini", "--printer", "P"] if presets_of(number) else []
    subprocess.run([BIN / "slicefarm", "slice", model_of(number, directory), "--generic", "-q", "-o", out, *presets, *settings_of(number)], check=True)
    digest = hashlib.sha256(out.read_bytes()).hexdigest()
    out.unlink()
    return digest


class Submitter(threading.Thread):
    """Submits jobs one after another, each until it is acknowledged. Waits for the permission for each job."""

    def __init__(self, farm, count, directory):
        super().__init__()
        self.directory = directory
        self.farm, self.count, self.acknowledged, self.refused = farm, count, {}, []
        self.lost_presets = []
        self.let, self.allowed = threading.Semaphore(0), 0

    def allow(self, count):
        for _ in range(min(count, self.count) - self.allowed):
            self.let.release()
            self.allowed += 1

    def run(self):
        for number in range(self.count):
            self.let.acquire()
            presets = []
            if presets_of(number):
                if not import_presets(self.farm, number, self.directory):
                    self.lost_presets.append(f"presets of job {number}")
                presets = ["--printer", "P", "--bundle", f"acme{presets_of(number)}@1"]
            done = self.farm.client("submit", model_of(number, self.directory), "--detach", "-q", "--label", f"number={number}", *presets, *settings_of(number))
            if done.returncode == 0:
                self.acknowledged[number] = done.stdout.strip()
            elif presets and "there is no" in done.stderr:
                self.lost_presets.append(f"presets of job {number}: {done.stderr.strip()}")
            else:
                self.refused.append(done.stderr.strip())


def kill_at_random(farm, submitter, options):
    """Kills random processes and restarts them at once. Sometimes a worker is only slow. Returns the victims and times
    of the kills during work, and the counter of finished ranges."""
    rng = random.Random(options.seed)
    killed, ranges = [], Ranges(farm.coordinators)
    for i in range(options.kills):
        submitter.allow(i * submitter.count // options.kills + LEAD)
        time.sleep(rng.expovariate(1 / PAUSE_S))
        if rng.random() < options.slow:
            rng.choice(farm.workers).pause(rng.uniform(0.5, 2))
        victim = rng.choice(farm.victims)
        if farm.has_work():
            killed.append((victim.name, time.monotonic()))
        ranges.look()
        victim.kill()
        victim.start()
    submitter.allow(submitter.count)
    return killed, ranges


class Ranges:
    """Counts the finished ranges over all lives of the coordinators. The count is slightly too low, because ranges just
    before a kill are missed."""

    def __init__(self, coordinators):
        self.coordinators, self.last, self.count = coordinators, {}, 0

    def look(self):
        for coordinator in self.coordinators:
            now = coordinator.metric('slicefarm_ranges_total{outcome="ok"}') or 0
            before = self.last.get(coordinator.name, 0)
            self.count += now - before if now >= before else now
            self.last[coordinator.name] = now


def fetched_digest(farm, job_id, directory):
    """Returns the digest of the downloaded G-code; None if the download fails."""
    path = directory / "fetched.gcode"
    done = farm.client("get", job_id, "-o", path)
    return hashlib.sha256(path.read_bytes()).hexdigest() if done.returncode == 0 else None


def judge(farm, acknowledged, jobs, directory):
    by_id = {job["id"]: job for job in jobs}
    numbers = collections.Counter(job["labels"]["number"] for job in jobs)
    lost, differing = [], []
    for number, job_id in acknowledged.items():
        job = by_id.get(job_id)
        if job is None or job["state"] != "JOB_STATE_SUCCEEDED":
            lost.append((number, job_id, job and job.get("error", job["state"])))
            continue
        digest = fetched_digest(farm, job_id, directory)
        if digest is None:
            lost.append((number, job_id, "its G-code"))
        elif digest != expected_digest(number, directory):
            differing.append((number, job_id))
    duplicated = sum(count - 1 for count in numbers.values())
    return lost, duplicated, differing


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=100)
    parser.add_argument("--jobs", type=int, default=50)
    parser.add_argument("--store", choices=["sqlite", "postgres", "s3"], default="sqlite")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--split", action="store_true")
    parser.add_argument("--slow", type=float, default=0.0)
    options = parser.parse_args()
    directory = pathlib.Path(tempfile.mkdtemp(prefix="slicefarm-faults-"))
    random.seed(options.seed)
    s3_faults = S3_FAULTS if options.store == "s3" else 0
    with running_farm(options.store, directory, workers=options.workers, split=options.split, s3_faults=s3_faults) as farm:
        progress = Progress(farm.coordinators)
        submitter = Submitter(farm, options.jobs, directory)
        try:
            submitter.start()
            killed, ranges = kill_at_random(farm, submitter, options)
            submitter.join()
            jobs = farm.await_end(PATIENCE_S)
            ranges.look()
        finally:
            progress.stop()
        lost, duplicated, differing = judge(farm, submitter.acknowledged, jobs, directory)
        lost += submitter.lost_presets
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
        ("ranges", int(ranges.count)),
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
