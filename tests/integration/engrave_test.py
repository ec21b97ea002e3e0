#!/usr/bin/env python3
"""Tests engraving jobs from surface to points: the report, each kind of texture, and refusals with their errors.
LinuxCNC's interpreter reads the programs if it is installed. A farm of real processes, some of which are killed
meanwhile, must produce the bytes of `slicefarm slice`.

usage: engrave_test.py SLICEFARM
"""
import csv
import json
import math
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

SIDE = 20


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def must(program, *arguments):
    done = run(program, *arguments)
    assert done.returncode == 0, f"{arguments}: {done.returncode} {done.stderr}"
    return done.stdout


def height(x):
    return (x - SIDE / 2) ** 2 / 30


def write_roof(path):
    """Writes a square bent to a parabola, far from the file's origin; its coordinates are not whole nanometres."""
    at = lambda x: 100 + x / 3
    points = "".join(f"v {at(x)!r} {y / 3!r} {height(x) / 3!r}\n" for y in range(SIDE + 1) for x in range(SIDE + 1))
    corner = lambda x, y: y * (SIDE + 1) + x + 1
    faces = "".join(
        f"f {corner(x, y)} {corner(x + 1, y)} {corner(x + 1, y + 1)}\nf {corner(x, y)} {corner(x + 1, y + 1)} {corner(x, y + 1)}\n"
        for y in range(SIDE)
        for x in range(SIDE)
    )
    path.write_text(points + faces)
    return path


def write_png(path, size=8):
    rows = b"".join(b"\0" + bytes(255 if 2 <= x < 6 and 2 <= y < 6 else 0 for x in range(size)) for y in range(size))
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", size, size, 8, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
    return path


def write_pyramid(path):
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (1, 1, 0.3)]
    faces = [(0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4), (0, 2, 1), (0, 3, 2)]
    data = b"\0" * 80 + struct.pack("<I", len(faces))
    for face in faces:
        data += struct.pack("<3f", 0, 0, 0) + b"".join(struct.pack("<3f", *corners[i]) for i in face) + b"\0\0"
    path.write_bytes(data)
    return path


def engrave(program, surface, out, texture, *more):
    must(program, "slice", surface, "--machine", "engrave", "--texture", texture, "-o", out, "-q", "--set", "spacing=0.2", *more)
    return out.read_bytes()


def distance_to_roof(x, y, z):
    """Returns the distance of a point from the roof. The roof consists of plane strips; the nearest strips are checked."""
    column = min(max(int((x - 100) * 3), 0), SIDE - 1)
    best = math.inf
    for i in range(max(column - 1, 0), min(column + 2, SIDE)):
        x0, x1, z0, z1 = 100 + i / 3, 100 + (i + 1) / 3, height(i) / 3, height(i + 1) / 3
        long = math.hypot(x1 - x0, z1 - z0)
        t = min(max(((x - x0) * (x1 - x0) + (z - z0) * (z1 - z0)) / long**2, 0), 1)
        best = min(best, math.hypot(x - x0 - t * (x1 - x0), z - z0 - t * (z1 - z0)))
    return best


def check_points(program, folder):
    """Checks that the points of the base are above the surface by the offset of their layer, at the precision of the
    file's doubles. Checks that --anchor and --orient change the result.
    """
    roof = write_roof(folder / "roof.obj")
    text = engrave(program, roof, folder / "out.csv", "bumps:pitch=2,height=0.3", "--report", folder / "r.json").decode()
    report = json.loads((folder / "r.json").read_text())
    layers = report["engraving"]["layers"]
    assert report["engraving"]["layer_count"] == len(layers) == 6, report
    assert set(report["engraving"]["map"]["stretch"]) == {"p1", "p50", "p99"}
    rows = list(csv.DictReader(text.splitlines()))
    assert list(rows[0]) == ["path", "layer", "x", "y", "z", "nx", "ny", "nz", "on"]
    assert len(rows) == sum(layer["points"] for layer in layers)
    worst = 0
    for row in rows:
        x, y, z, nx, ny, nz = (float(row[k]) for k in ("x", "y", "z", "nx", "ny", "nz"))
        offset = layers[int(row["layer"])]["offset_mm"]
        worst = max(worst, distance_to_roof(x - offset * nx, y - offset * ny, z - offset * nz))
    assert worst < 1e-9, worst
    turned = engrave(program, roof, folder / "turned.csv", "bumps:pitch=2,height=0.3", "--anchor", "103,3,0", "--orient", "0,1,0")
    assert turned != text.encode()


def check_textures(program, folder):
    """Checks files as textures and masks, and that the bytes are the same for each number of threads."""
    roof = write_roof(folder / "roof.obj")
    png, solid = write_png(folder / "t.png"), write_pyramid(folder / "t.stl")
    for texture, more in (
        ("knurl:pitch=2,height=0.2", []),
        (png, ["--set", "texture_width=2", "--set", "texture_height=0.2"]),
        (solid, ["--set", "texture_pitch=2.5,3"]),
        ("waves", ["--mask", png, "--set", "equidistant=1"]),
    ):
        for suffix in ("csv", "nc"):
            one = engrave(program, roof, folder / f"one.{suffix}", texture, *more, "--threads", 1)
            assert one == engrave(program, roof, folder / f"five.{suffix}", texture, *more, "--threads", 5), texture
            assert one.count(b"\n") > 100, f"{texture} {suffix}"


def check_whole_files(program, folder):
    """Checks the output formats that the file name selects: pictures, and the surface with the texture in it."""
    roof = write_roof(folder / "roof.obj")
    texture = "bumps:pitch=2,height=0.3"
    stl = engrave(program, roof, folder / "with.stl", texture, "--report", folder / "r.json")
    assert json.loads((folder / "r.json").read_text())["layers"] == 6
    count = struct.unpack_from("<I", stl, 80)[0]
    assert len(stl) == 84 + 50 * count and count > 2 * SIDE * SIDE
    places = [struct.unpack_from("<3f", stl, 84 + 50 * t + 12 + 12 * k) for t in range(count) for k in range(3)]
    offsets = [distance_to_roof(*place) for place in places]
    assert 0.25 < max(offsets) < 0.31 and min(offsets) < 1e-4, (min(offsets), max(offsets))
    assert stl == engrave(program, roof, folder / "threads.stl", texture, "--threads", 3)
    obj = engrave(program, roof, folder / "with.obj", texture, "--set", "displaced_edge=0.1").decode()
    assert obj.count("\nf ") > count and engrave(program, roof, folder / "any", texture, "--format", "stl") == stl
    pictures = [engrave(program, roof, folder / name, texture) for name in ("lines.png", "flat.map.png")]
    for picture in pictures:
        assert picture.startswith(b"\x89PNG") and max(struct.unpack_from(">II", picture, 16)) == 1200
    assert pictures[0] != pictures[1]


def check_refusals(program, folder):
    roof = write_roof(folder / "roof.obj")
    broken = folder / "broken.obj"
    broken.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 4 5 6\n")
    engraving = ["--machine", "engrave"]
    for model, given, words in (
        (roof, [*engraving, "--texture", "bricks"], "bricks"),
        (roof, [*engraving, "--texture", "bumps:pitch=-1"], "pitch"),
        (roof, [*engraving, "--anchor", "1,2"], "anchor"),
        (roof, [*engraving, "--texture", folder / "none.png"], "none.png"),
        (roof, [*engraving, "--set", "perimeters=3"], "process fdm"),
        (roof, [*engraving, "--copies", "roof.obj=2"], "one copy"),
        (broken, engraving, "do not hang together"),
        (roof, ["--texture", "bumps"], "--machine engrave"),
        (roof, [*engraving, "--format", "stl", "--set", "displaced_edge=0.0015", "--texture", "bumps"], "triangles"),
    ):
        done = run(program, "slice", model, "-o", folder / "bad.csv" if "--machine" in given else folder / "bad.gcode", *given)
        assert done.returncode not in (0, 1) and words in done.stderr, f"{given}: {done.returncode} {done.stderr}"
        assert not (folder / "bad.csv").exists()


def check_interpreter(program, folder):
    """Checks that LinuxCNC's own interpreter reads the programs of all axis layouts."""
    rs274 = shutil.which("rs274")
    if rs274 is None:
        print("rs274 is not installed (linuxcnc-uspace): programs are not read by it")
        return
    roof = write_roof(folder / "roof.obj")
    for axes in ("none", "table-ab", "table-bc", "head-ab", "head-bc"):
        engrave(program, roof, folder / "rs.nc", "bumps:pitch=2,height=0.1", "--set", f"axes={axes}")
        done = run(rs274, "-g", folder / "rs.nc")
        assert done.returncode == 0 and "error" not in done.stderr.lower(), f"{axes}: {done.stderr[-2000:]}"


def check_farm(program, folder):
    """Checks that a farm produces the same bytes as the command line, with fused workers and with split stages, while
    some of them are killed.
    """
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    roof, solid = write_roof(folder / "roof.obj"), write_pyramid(folder / "t.stl")
    given = ["--machine", "engrave", "--texture", solid, "--set", "spacing=0.05", "--set", "layer_height=0.01", "--set", "output_format=csv"]
    must(program, "slice", roof, "-o", folder / "here.csv", "-q", *given)
    here = (folder / "here.csv").read_bytes()
    for split in (False, True):
        with running_farm(split=split) as farm:
            waiting = farm.client("submit", roof, "--detach", "-q", *given)
            assert waiting.returncode == 0, waiting.stderr
            killed = farm.workers[0] if not split else next(s for s in farm.services if s.name.startswith("texture"))
            for _ in range(2):
                killed.kill()
                killed.start()
            job = waiting.stdout.strip()
            done = farm.client("watch", job)
            assert done.returncode == 0, done.stderr
            done = farm.client("get", job, "-o", folder / "there.csv")
            assert done.returncode == 0, done.stderr
            assert (folder / "there.csv").read_bytes() == here, f"split {split}"


def main(program):
    with tempfile.TemporaryDirectory() as name:
        for check in (check_points, check_textures, check_whole_files, check_refusals, check_interpreter, check_farm):
            check(program, pathlib.Path(name))
            print(f"{check.__name__}: ok", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
