#!/usr/bin/env python3
"""Runs a part of the tests that take hours, a different part each day: some fuzz targets for 20 s each, kills of a
farm's processes, faults of its disk.

usage: rotation.py BUILD [--day N] [--minutes M] [--fuzzers]

BUILD: build folder with tests.
--day: selects the part (days since 1970).
--minutes: no new step begins after this time (10).
--fuzzers: all fuzz targets, and nothing else.
Exit code 1 if a step fails; the script prints its command, so that it can be run again.
"""
import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
FUZZERS_A_DAY, FUZZ_S = 4, 20


def fuzz_steps(build, day, count):
    fuzzers = sorted(path for path in (build / "fuzz").glob("fuzz_*") if os.access(path, os.X_OK))
    assert fuzzers, f"{build}/fuzz has no fuzz targets: they are built with the tests"
    for i in range(min(count, len(fuzzers))):
        fuzzer = fuzzers[(day * FUZZERS_A_DAY + i) % len(fuzzers)]
        seeds = ROOT / "tests/corpus/fuzz" / fuzzer.name.removeprefix("fuzz_")
        yield [fuzzer, seeds if seeds.is_dir() else ROOT / "tests/corpus/fuzz/stl", str(FUZZ_S), str(day)], {}


def steps(build, day):
    yield from fuzz_steps(build, day, FUZZERS_A_DAY)
    store = ("sqlite", "postgres")[day % 2]
    yield [ROOT / "tests/faults.sh", "--kills", "20", "--jobs", "10", "--store", store, "--seed", str(day)], {"SLICEFARM_BIN": build / "bin"}
    # CTest tries fewer errors and power cuts.
    yield [build / "tests/coordinator_faults_test"], {"SLICEFARM_FAULT_ERRORS": "30", "SLICEFARM_FAULT_SEEDS": "2"}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--day", type=int, default=int(time.time()) // 86400)
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--fuzzers", action="store_true")
    options = parser.parse_args()
    until, failed, left_out = time.monotonic() + 60 * options.minutes, [], []
    with tempfile.TemporaryDirectory(prefix="slicefarm-") as folder:
        build = options.build.resolve()
        for command, variables in fuzz_steps(build, options.day, 1000) if options.fuzzers else steps(build, options.day):
            words = " ".join([*(f"{name}={value}" for name, value in variables.items()), *map(str, command)])
            if time.monotonic() >= until:
                left_out.append(words)
                continue
            print(f"rotation: {words}", flush=True)
            environment = os.environ | {name: str(value) for name, value in variables.items()}
            if subprocess.run(command, env=environment, cwd=folder).returncode != 0:
                failed.append(words)
                crashed = pathlib.Path(folder) / "last-input"
                if crashed.exists():
                    print("its last input, in hex:", crashed.read_bytes().hex())
                    crashed.unlink()
    for words in left_out:
        print("no time for:", words)
    for words in failed:
        print("FAILED:", words)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
