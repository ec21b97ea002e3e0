#!/usr/bin/env python3
"""Tests an upgrade and its rollback, under load and with kills. A farm of another build is started beside a working
farm on the same PostgreSQL, whose schema has additions of a later build. The first farm is stopped (SIGTERM), then
started again, and the second farm is stopped.

  tests/upgrade.py [--kills 40] [--jobs 40] [--seed S]

Prints `key value` rows: kills, jobs, lost, duplicated and differing as in tests/faults.sh; jobs_old and jobs_new, the
jobs made by each build; longest_pause_s, the longest time without a finished range. Exit code 1 if a job is lost,
duplicated or differs, if a build made no job, or if no range was finished for a minute. SLICEFARM_BIN: folder of the
programs (default build/bin).

The other build is the same programs with another build id written into them. Its output is the same, but no service of
one build works with a service of the other.
"""
import argparse
import collections
import contextlib
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import time

from faults import Submitter, judge
from local_farm import BIN, Farm, Postgres, Progress

PAUSE_S = 0.6  # mean time between kills
PHASES = 5  # running builds: old; old and new; new; new and old; old
# Changes that a later build may make to a schema used by this one.
LATER_SCHEMA = """
ALTER TABLE jobs ADD COLUMN of_a_later_build TEXT NOT NULL DEFAULT '';
CREATE INDEX CONCURRENTLY of_a_later_build ON jobs (of_a_later_build, number);
INSERT INTO slicefarm_migrations (name) VALUES ('9999_of_a_later_build');
"""
PATIENCE_S = 600
PROGRAMS = [f"slicefarm-{name}" for name in ("coordinator", "worker", "slicing", "mesh-reader", "planning", "motion", "exposure", "milling", "texture")]


def build_id():
    return re.search(r"build ([0-9a-f]{16})", subprocess.run([BIN / "slicefarm", "version"], stdout=subprocess.PIPE, text=True).stdout)[1]


def other_build(directory):
    """Copies all programs, with another build id."""
    old, new = build_id().encode(), b"0123456789abcdef"
    directory.mkdir()
    for name in PROGRAMS:
        data = (BIN / name).read_bytes()
        assert name == "slicefarm-mesh-reader" or old in data, f"{name} is not of this build"
        copy = directory / name
        copy.write_bytes(data.replace(old, new))
        copy.chmod(0o755)
    return directory


class TwoBuilds:
    """Two farms, one of each build, on one database; clients reach the running coordinators."""

    client, jobs, await_end = Farm.client, Farm.jobs, Farm.await_end

    def __init__(self, directory):
        self.postgres = Postgres(directory / "postgres")
        self.programs = {"old": BIN, "new": other_build(directory / "programs")}
        self.directory, self.farms = directory, {}

    @property
    def coordinators(self):
        return [coordinator for farm in self.farms.values() for coordinator in farm.coordinators]

    def start(self, build):
        """Starts the farm of a build. A second start has new processes and the same coordinator names."""
        home = self.directory / f"life-{time.monotonic_ns()}" / build
        home.mkdir(parents=True)
        home.parent.chmod(0o755)
        farm = Farm("postgres", home, postgres=self.postgres, programs=self.programs[build])
        self.farms[build] = farm
        farm.await_serving()

    def stop(self, build):
        farm = self.farms.pop(build)
        for coordinator in farm.coordinators:  # coordinators stop first, as the documentation tells operators
            coordinator.stop()
        for service in farm.services:
            if service not in farm.coordinators:
                service.stop()

    def kill_one(self, rng):
        victim = rng.choice([*(service for farm in self.farms.values() for service in farm.services), self.postgres])
        victim.kill()
        victim.start()

    def sql(self, text):
        for statement in filter(str.strip, text.split(";\n")):
            command = ["psql", "-At", "-q", "-v", "ON_ERROR_STOP=1", self.postgres.connection, "-c", statement]
            done = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
        return done.stdout.splitlines()


def enter(phase, farms):
    if phase == 1:
        farms.sql(LATER_SCHEMA)
        farms.start("new")
    elif phase == 2:
        farms.stop("old")
    elif phase == 3:
        farms.start("old")
    elif phase == 4:
        farms.stop("new")


def upgrade_and_back(farms, submitter, options, seen):
    rng = random.Random(options.seed)
    for phase in range(PHASES):
        enter(phase, farms)
        seen.append(Progress(farms.coordinators))
        submitter.allow((phase + 1) * submitter.count // PHASES)
        for _ in range(options.kills // PHASES):
            time.sleep(rng.expovariate(1 / PAUSE_S))
            farms.kill_one(rng)
        while len(submitter.acknowledged) + len(submitter.refused) < submitter.allowed - 2:
            time.sleep(0.1)


def longest_pause_s(seen, begun, ended):
    times = sorted([begun, *(t for progress in seen for t in progress.times if begun < t < ended), ended])
    return max(b - a for a, b in zip(times, times[1:]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--kills", type=int, default=40)
    parser.add_argument("--jobs", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    directory = pathlib.Path(tempfile.mkdtemp(prefix="slicefarm-upgrade-"))
    directory.chmod(0o755)
    random.seed(options.seed)
    farms, seen = TwoBuilds(directory), []
    with contextlib.ExitStack() as ending:
        ending.callback(farms.postgres.stop)
        ending.callback(lambda: [farms.stop(build) for build in list(farms.farms)])
        ending.callback(lambda: [progress.stop() for progress in seen])
        farms.start("old")
        begun = time.monotonic()
        submitter = Submitter(farms, options.jobs, directory)
        submitter.start()
        upgrade_and_back(farms, submitter, options, seen)
        submitter.join()
        jobs = farms.await_end(PATIENCE_S)
        pause_s = longest_pause_s(seen, begun, time.monotonic())
        lost, duplicated, differing = judge(farms, submitter.acknowledged, jobs, directory)
        made = collections.Counter(farms.sql("SELECT build_id FROM jobs WHERE state = 'SUCCEEDED'"))
        old = made.pop(build_id(), 0)
    rows = [("kills", options.kills // PHASES * PHASES), ("jobs", len(submitter.acknowledged)), ("refused", len(submitter.refused)),
            ("lost", len(lost)), ("duplicated", duplicated), ("differing", len(differing)), ("jobs_old", old),
            ("jobs_new", made.total()), ("longest_pause_s", f"{pause_s:.1f}")]
    for key, value in rows:
        print(key, value)
    bad = lost or duplicated or differing or not old or not made or pause_s > 60
    for what in [*lost, *differing, *submitter.refused]:
        print("seed", options.seed, what, file=sys.stderr)
    if bad:
        print("logs:", directory, file=sys.stderr)
        return 1
    shutil.rmtree(directory)
    return 0


if __name__ == "__main__":
    sys.exit(main())
