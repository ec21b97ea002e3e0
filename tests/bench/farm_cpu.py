#!/usr/bin/env python3
"""Measures the rate of small jobs on a farm, and the CPU time of a job on the farm relative to the same job alone.

usage: farm_cpu.py [MODEL] [--jobs N] [--clients N] [--config FILE]

MODEL: benchy of the corpus. The jobs differ in fill_density, so that none takes the result of another one. The farm has one
coordinator with SQLite and two workers with one slot each. All programs must be of one build. Prints rows: name value. CPU times are user and system seconds per
job: of all services, of the slowest parts, of the clients, and of `slicefarm slice`.
"""
import argparse
import concurrent.futures
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from local_farm import BIN, MODELS, running_farm


def children_cpu_s():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def cpu_s(service):
    """Returns the CPU seconds of a service and of its ended children, such as the mesh reader."""
    fields = service.proc("stat").rpartition(")")[2].split()
    return sum(map(int, fields[11:15])) / os.sysconf("SC_CLK_TCK")


def settings(options, number):
    config = ["--config", options.config] if options.config else ["--generic"]
    return [*config, "--set", f"fill_density={10 + number * 80 / options.jobs:.2f}%"]


def run(command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert done.returncode == 0, done.stderr


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("model", nargs="?", type=pathlib.Path, default=MODELS / "benchy.stl")
    parser.add_argument("--jobs", type=int, default=40)
    parser.add_argument("--clients", type=int, default=8)
    parser.add_argument("--config")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        before = children_cpu_s()
        for number in range(0, options.jobs, 4):
            run([BIN / "slicefarm", "slice", options.model, "-q", "-o", f"{folder}/alone.gcode", "--threads", "1", *settings(options, number)])
        alone = (children_cpu_s() - before) / len(range(0, options.jobs, 4))
        with running_farm(workers=2) as farm:
            def submit(number):
                run([BIN / "slicefarm", "submit", options.model, "-q", "-o", f"{folder}/{number}.gcode", "--server",
                     farm.coordinators[0].address, *settings(options, number)])

            submit(options.jobs)  # the farm stores the mesh, and its services have read their libraries
            cpu = {service.name: cpu_s(service) for service in farm.services}
            before, begin = children_cpu_s(), time.monotonic()
            with concurrent.futures.ThreadPoolExecutor(options.clients) as pool:
                list(pool.map(submit, range(options.jobs)))
            seconds, clients = time.monotonic() - begin, (children_cpu_s() - before) / options.jobs
            parts = {service.name: (cpu_s(service) - cpu[service.name]) / options.jobs for service in farm.services}
    total = sum(parts.values())
    print(f"jobs_per_minute {60 * options.jobs / seconds:.0f}")
    print(f"slice_cpu_s {alone:.3f}")
    print(f"farm_cpu_s {total:.3f}")
    print(f"farm_to_slice {total / alone:.3f}")
    print(f"clients_cpu_s {clients:.3f}")
    for name, part in sorted(parts.items(), key=lambda item: -item[1]):
        if part >= 0.001:
            print(f"{name}_cpu_s {part:.3f}")


if __name__ == "__main__":
    main()
