#!/usr/bin/env python3
"""Tests deploy/backup.sh and restore.sh with real processes. Jobs are submitted while the backup runs. The restored
farm must have all jobs that were acknowledged before the backup began, and must produce the same bytes for them.

    tests/backup_test.py sqlite|postgres [--tenants]        SLICEFARM_BIN: folder of the programs (build/bin)
"""
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parent.parent
BIN = pathlib.Path(os.environ.get("SLICEFARM_BIN", ROOT / "build/bin")).resolve()
BEFORE = 6  # jobs that are acknowledged before the backup begins


def cube(path):
    corners = [(x, y, z) for z in (0, 12) for y in (0, 12) for x in (0, 12)]
    faces = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]
    lines = ["v %d %d %d" % c for c in corners] + ["f %d %d %d %d" % f for f in faces]
    path.write_text("\n".join(lines) + "\n")


class Server:
    def __init__(self, program, *arguments, env=None):
        command = [BIN / f"slicefarm-{program}", "--listen", "127.0.0.1:0", *arguments]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, env=env)
        for line in self.process.stdout:
            if line.startswith("listening on "):
                self.address = line.split()[-1]
                return
        raise SystemExit(f"slicefarm-{program} does not serve")

    def stop(self):
        self.process.terminate()
        self.process.wait()


class Store:
    """Location of a coordinator's state."""

    def __init__(self, kind, directory):
        self.kind, self.directory = kind, directory
        self.env = dict(os.environ)
        self.env.pop("SLICEFARM_POSTGRES", None)
        if kind == "postgres":
            self.env["SLICEFARM_POSTGRES"] = self.server("start")

    def server(self, command):
        run = subprocess.run([ROOT / "deploy/postgres/server.sh", command, self.directory], stdout=subprocess.PIPE, text=True)
        return run.stdout.strip()

    def arguments(self):
        return ["--state-dir", self.directory] if self.kind == "sqlite" else []

    def backup(self, dest):
        source = [self.directory] if self.kind == "sqlite" else []
        subprocess.run([ROOT / "deploy/backup.sh", self.kind, *source, dest], check=True, env=self.env)

    def restore(self, backup):
        to = [self.directory] if self.kind == "sqlite" else []
        command = [ROOT / "deploy/restore.sh", self.kind, backup, *to]
        return subprocess.run(command, env=self.env, stderr=subprocess.PIPE, text=True)

    def notes_of_use(self):
        """Returns the number of usage notes in the database. A restored database has none, so no blob is swept for a
        day.
        """
        sql = "SELECT count(*) FROM chores WHERE name IN ('use_begin', 'use_last')"
        command = ["sqlite3", self.directory / "jobs.db", sql]
        if self.kind == "postgres":
            command = ["psql", "-XAtc", sql, self.env["SLICEFARM_POSTGRES"]]
        return int(subprocess.run(command, check=True, capture_output=True, text=True).stdout)

    def close(self):
        if self.kind == "postgres":
            self.server("stop")


TOKEN = "sf_of_a_test"


class Farm:
    def __init__(self, stages, store):
        self.coordinator = Server("coordinator", *store.arguments(), "--jobs", "1", *stages, env=store.env)
        self.env = dict(os.environ, SLICEFARM_TOKEN=TOKEN)

    def call(self, *arguments, check=True):
        command = [BIN / "slicefarm", *arguments, "--server", self.coordinator.address]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=self.env)
        if check and run.returncode != 0:
            raise SystemExit(f"{arguments}: {run.stderr}")
        return run.stdout

    def submit(self, model, number):
        return self.call("submit", model, "--detach", "--generic", "--set", f"fill_density={5 + number}%").strip()

    def result(self, job, folder):
        """Waits for the G-code and returns its digest."""
        self.call("watch", job)
        path = folder / "out.gcode"
        self.call("get", job, "-o", path)
        return hashlib.sha256(path.read_bytes()).hexdigest()


def expect(condition, message):
    if not condition:
        raise SystemExit(f"backup_test: {message}")


def check_damage(kind, work, backup):
    """Checks that a changed byte in the backup is detected."""
    if kind == "postgres":
        return  # pg_restore and coordinators detect damage themselves
    spoilt = work / "spoilt"
    shutil.copytree(backup, spoilt)
    blob = next(path for path in spoilt.rglob("*") if path.is_file() and len(path.name) == 64)
    blob.write_bytes(blob.read_bytes() + b"!")
    restored = Store(kind, work / "from-spoilt").restore(spoilt)
    expect(restored.returncode != 0 and blob.name in restored.stderr, "damage was not found")
    expect(not list((work / "from-spoilt").rglob(blob.name)), "what was damaged was brought back")


def bring_back(kind, work, place):
    store = Store(kind, work / place)
    outcome = store.restore(work / "backup")
    expect(outcome.returncode == 0, outcome.stderr)
    expect(store.notes_of_use() == 0, "a restored database counts as one in use")
    return store


def run(kind, work, stages):
    model = work / "cube.obj"
    cube(model)
    original = Store(kind, work / "original")
    farm = Farm(stages, original)
    acknowledged, stop = [], threading.Event()
    enough = threading.Event()

    def keep_submitting():
        for number in range(90):
            if stop.is_set():
                return
            acknowledged.append(farm.submit(model, number))
            if len(acknowledged) == BEFORE:
                enough.set()

    submitter = threading.Thread(target=keep_submitting)
    submitter.start()
    enough.wait()
    farm.call("watch", acknowledged[0])  # at least one job has ended; the other jobs wait or run
    before = list(acknowledged)
    expect(original.notes_of_use() == 2, "a coordinator does not note its use of the database")
    original.backup(work / "backup")
    during = len(acknowledged) - len(before)
    stop.set()
    submitter.join()
    expect(original.restore(work / "backup").returncode != 0, "a state was overwritten")
    restored = [bring_back(kind, work, "first")]
    digests = {job: farm.result(job, work) for job in before}
    original.backup(work / "backup")  # second backup into the same folder, with all jobs
    restored.append(bring_back(kind, work, "second"))
    farm.coordinator.stop()
    original.close()

    for store in restored:
        farm = Farm(stages, store)
        for job, digest in digests.items():
            expect(farm.result(job, work) == digest, f"job {job} came to other bytes")
        farm.coordinator.stop()
        store.close()
    check_damage(kind, work, work / "backup")
    print(f"{kind}: {len(before)} jobs acknowledged before the backup, {during} while it ran; all of the first are there")


def main():
    kind = sys.argv[1]
    work = pathlib.Path(tempfile.mkdtemp(prefix="slicefarm-backup-"))
    os.chmod(work, 0o755)  # PostgreSQL's user must be able to enter it
    servers = {name: Server(name) for name in ("slicing", "planning", "motion", "worker")}
    stages = ["--slicing", servers["slicing"].address, "--planning", servers["planning"].address, "--motion", servers["motion"].address,
              "--workers", servers["worker"].address]
    if "--tenants" in sys.argv:
        entry = {"sha256": hashlib.sha256(TOKEN.encode()).hexdigest(), "scopes": ["submit", "read"]}
        tenants = work / "tenants.json"
        tenants.write_text(json.dumps({"tenants": {"acme": {"tokens": [entry]}}}))
        stages += ["--tenants", str(tenants)]
    try:
        run(kind, work, stages)
    finally:
        for server in servers.values():
            server.stop()
        shutil.rmtree(work, ignore_errors=True)


if __name__ == "__main__":
    main()
