#!/usr/bin/env python3
"""Tests deploy/move-blobs.sh with real processes: out of PostgreSQL while two coordinators work and clients download,
interrupted in the middle and run again; and out of a state directory. Every G-code must stay the same, and no blob
may remain at the source.

usage: s3_move_test.py SLICEFARM
"""
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, ROOT, FakeS3, running_farm

JOBS = 6


def digest_of(farm, job, folder, name="fetched"):
    out = folder / f"{name}.gcode"
    done = farm.client("get", job, "-o", out)
    assert done.returncode == 0, done.stderr
    return hashlib.sha256(out.read_bytes()).hexdigest()


def submit_some(farm, folder):
    """Submits jobs, waits for their end, and returns {job: digest of its G-code}."""
    jobs = [farm.submit(MODELS / "textbox.stl", "--set", f"layer_height=0.{20 + n}") for n in range(JOBS)]
    assert {job["state"] for job in farm.await_end()} == {"JOB_STATE_SUCCEEDED"}
    return {job: digest_of(farm, job, folder) for job in jobs}


def move(source, bucket, **options):
    command = [ROOT / "deploy/move-blobs.sh", source, bucket.url]
    return subprocess.Popen(command, env={**os.environ, **bucket.environment, "SLICEFARM_BIN": str(BIN)}, stdout=subprocess.PIPE, text=True, **options)


def finish(moving):
    out, _ = moving.communicate(timeout=120)
    assert moving.returncode == 0, out
    return out.splitlines()[-1]


class Fetching(threading.Thread):
    """Downloads the G-code of all jobs repeatedly."""

    def __init__(self, farm, jobs, folder):
        super().__init__()
        self.farm, self.jobs, self.folder, self.ended, self.count, self.wrong = farm, jobs, folder, threading.Event(), 0, []
        self.start()

    def run(self):
        while not self.ended.is_set():
            for job, digest in self.jobs.items():
                self.count += 1
                if digest_of(self.farm, job, self.folder, "meanwhile") != digest:
                    self.wrong.append(job)

    def stop(self):
        self.ended.set()
        self.join()
        assert self.count and not self.wrong, (self.count, self.wrong)


def rows(farm, sql):
    done = subprocess.run(["psql", "-At", farm.postgres.connection, "-c", sql], check=True, stdout=subprocess.PIPE, text=True)
    return int(done.stdout)


def out_of_postgres(folder):
    bucket = FakeS3(folder / "bucket")
    os.environ.update(bucket.environment)
    try:
        with running_farm("postgres", folder / "farm") as farm:
            jobs = submit_some(farm, folder)
            for coordinator in farm.coordinators:  # one after the other, as in an upgrade
                coordinator.stop()
                coordinator.command += ["--s3", bucket.url]
                coordinator.start()
            farm.await_serving()
            fetching = Fetching(farm, jobs, folder)
            moving = move(farm.postgres.connection, bucket)
            ended = None
            while rows(farm, "SELECT count(*) FROM s3_blobs") < 3:
                assert ended is None, "it ended, and moved fewer than three"
                ended = moving.poll()
            moving.kill()
            moving.wait()
            finish(move(farm.postgres.connection, bucket))
            more = submit_some(farm, folder)  # same jobs: all results must be in the cache
            assert all(job["result"].get("cached") for job in farm.jobs() if job["id"] in more)
            fetching.stop()
            assert rows(farm, "SELECT count(*) FROM blobs WHERE complete = 1") == 0
            assert {job: digest_of(farm, job, folder) for job in jobs} == jobs
            assert finish(move(farm.postgres.connection, bucket)).startswith("moved 0 blobs")
    finally:
        bucket.stop()


def out_of_a_directory(folder):
    bucket = FakeS3(folder / "bucket")
    os.environ.update(bucket.environment)
    try:
        with running_farm("sqlite", folder / "farm") as farm:
            jobs = submit_some(farm, folder)
            state = folder / "farm/state"
            coordinator, = farm.coordinators
            busy = move(str(state), bucket, stderr=subprocess.PIPE)
            assert "another" in busy.communicate(timeout=60)[1] and busy.returncode == 1, "a coordinator has the directory"
            coordinator.stop()
            moved = finish(move(str(state), bucket))
            assert not list((state / "blobs").glob("*/*")), moved
            coordinator.command += ["--s3", bucket.url]
            coordinator.start()
            farm.await_serving()
            assert {job: digest_of(farm, job, folder) for job in jobs} == jobs
    finally:
        bucket.stop()


def main(_):
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as name:
        for part in (out_of_postgres, out_of_a_directory):
            folder = pathlib.Path(name) / part.__name__
            (folder / "farm").mkdir(parents=True)
            for directory in (pathlib.Path(name), folder):
                directory.chmod(0o755)  # PostgreSQL's user must be able to enter it
            part(folder)
    print("all blobs moved, and every G-code is as before")


if __name__ == "__main__":
    main(*sys.argv[1:])
