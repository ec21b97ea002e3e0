"""Runs jobs that need more memory than there is. A program of 2 GB passes through a coordinator that never holds all of
it. Jobs with outlines that do not fit end with a typed error; the larger one has 150 million points, in a farm for
services of 4 GiB. Ordinary jobs beside them succeed."""
import math
import os
import pathlib
import re
import struct
import tempfile
import threading
import time

from local_farm import MODELS, running_farm

GCODE_MB = int(os.environ.get("SLICEFARM_EXHAUST_GCODE_MB", "1900"))
LAYER_BYTES = 120_000
# Cases by name: corners of a wavy outline, layer height in mm, --memory in MiB. Before simplification, a
# corner is two points of a layer.
OUTLINES = {"large": (4_000, 0.05, 128), "huge": (7_500, 0.02, 1_024)}
ORDINARY = 8


def prism(path, corners, radius_mm, height_mm, wave_mm=0.0):
    """Writes a binary STL of a prism on the plate. Its outline is wavy, so that no corner can be omitted."""
    ring = []
    for i in range(corners):
        radius = radius_mm + (wave_mm if i % 2 else 0)
        ring.append((radius * math.cos(2 * math.pi * i / corners), radius * math.sin(2 * math.pi * i / corners)))
    triangles = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        low, high = 0.0, height_mm
        triangles += [(0, 0, low, bx, by, low, ax, ay, low), (0, 0, high, ax, ay, high, bx, by, high)]
        triangles += [(ax, ay, low, bx, by, low, bx, by, high), (ax, ay, low, bx, by, high, ax, ay, high)]
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(struct.pack("<12fH", 0, 0, 0, *triangle, 0))


class Most(threading.Thread):
    """Measures the largest own memory of a process. Pages of files belong to the system and are not included."""

    def __init__(self, service):
        super().__init__()
        self.service, self.mib, self.ended = service, 0.0, threading.Event()
        self.start()

    def run(self):
        while not self.ended.wait(0.05):
            anonymous = re.search(r"^RssAnon:\s+(\d+)", self.service.proc("status"), re.MULTILINE)
            self.mib = max(self.mib, int(anonymous[1]) / 1024 if anonymous else 0)

    def stop(self):
        self.ended.set()
        self.join()
        return self.mib


def long_program(directory):
    layers = GCODE_MB * 1_000_000 // LAYER_BYTES
    model = pathlib.Path(directory) / "tower.stl"
    prism(model, 12, 4, layers * 0.02)
    text = "; " + "x" * (LAYER_BYTES // 2)
    settings = pathlib.Path(directory) / "long.ini"
    settings.write_text(
        f"layer_height = 0.02\nfirst_layer_height = 0.02\nmax_print_height = 1000\nperimeters = 1\nfill_density = 0\n"
        f"layer_gcode = {text}\nbefore_layer_gcode = {text}\n"
    )
    with running_farm() as farm:
        most = Most(farm.coordinators[0])
        begun = time.monotonic()
        farm.submit(model, "--config", settings)
        job = farm.await_end(3600)[0]
        seconds = time.monotonic() - begun
        yield "memory_long_program_failed", job["state"] != "JOB_STATE_SUCCEEDED", 0
        yield "memory_long_program_mb", int(job["result"].get("gcode_size") or job["result"].get("gcodeSize", 0)) / 1e6, None
        yield "memory_long_program_s", seconds, None
        yield "memory_long_program_coordinator_mib", most.stop(), 256


def outlines(directory, name, corners, layer_height, budget_mib):
    model = pathlib.Path(directory) / f"{name}.stl"
    prism(model, corners, 60, 200, wave_mm=0.2)
    with running_farm(extra=["--memory", str(budget_mib), "--jobs", "4"]) as farm:
        most = [Most(service) for service in (farm.coordinators[0], farm.services[0])]
        begun = time.monotonic()
        farm.submit(model, "--set", f"layer_height={layer_height}", "--set", "resolution=0")
        for i in range(ORDINARY):
            farm.submit(MODELS / "textbox.stl", "--set", f"perimeters={i + 1}")
        jobs = farm.await_end(3600)
        failed = [job for job in jobs if job["state"] == "JOB_STATE_FAILED"]
        yield f"memory_{name}_outlines_untyped", [job["error"]["reason"] for job in failed] != ["REQUEST_TOO_LARGE"], 0
        yield f"memory_{name}_outlines_s", time.monotonic() - begun, None
        yield f"memory_{name}_ordinary_failed", ORDINARY - sum(job["state"] == "JOB_STATE_SUCCEEDED" for job in jobs), 0
        for service, limit_mib in zip(most, (2 * budget_mib, 4_096)):
            yield f"memory_{name}_{service.service.name}_mib", service.stop(), limit_mib


def measure():
    with tempfile.TemporaryDirectory(prefix="slicefarm-exhaust-") as directory:
        for name, sizes in OUTLINES.items():
            yield from outlines(directory, name, *sizes)
        yield from long_program(directory)
