#!/usr/bin/env python3
"""Tests milling jobs from model to program: the report, each dialect, a picture of a level, and refusals with their
errors. LinuxCNC's interpreter reads the programs if it is installed. A farm of real processes, some of which are
killed meanwhile, must produce the bytes of `slicefarm slice`.

usage: mill_test.py SLICEFARM MODELS
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

BAD_MESH, BAD_SETTING = 3, 3  # exit codes of typed errors of the input
COARSE = ["--set", "cutter=cyl:3", "--set", "stepdown=2", "--set", "finish_stepdown=1", "--set", "finish_stepover=1"]


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def must(program, *arguments):
    done = run(program, *arguments)
    assert done.returncode == 0, f"{arguments}: {done.returncode} {done.stderr}"
    return done.stdout


def write_box(path, size, at=(0, 0, 0), lid=True):
    corners = [(at[0] + a * size[0], at[1] + b * size[1], at[2] + c * size[2]) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    faces += [(4, 5, 6), (5, 7, 6)] if lid else []
    path.write_text("".join(f"v {a} {b} {c}\n" for a, b, c in corners) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    return path


def numbers(text, letter):
    return [float(v) for v in re.findall(rf"^[^;(]*?{letter}(-?[\d.]+)", text, re.M)]


def mill(program, model, out, *settings, report=None, more=()):
    pairs = [part for setting in settings for part in ("--set", setting)]
    must(program, "slice", model, *more, "-o", out, "--machine", "mill", "-q", *pairs, *(["--report", report] if report else []))
    return out.read_text()


def check_program(program, models, folder):
    """Checks a box far from its file's origin: the program and the report use the coordinates of the file."""
    box = write_box(folder / "box.obj", (20, 10, 4), (100, 50, 7))
    text = mill(program, box, folder / "box.nc", "cutter=cyl:4", "stepdown=1", report=folder / "box.json")
    report = json.loads((folder / "box.json").read_text())
    milling = report["milling"]
    assert milling["part"]["min_mm"] == [100, 50, 7] and milling["stock"]["max_mm"] == [121, 61, 12], milling
    assert report["meshes"][0]["min_mm"] == [100, 50, 7]
    assert milling["gouge_check"]["gouges"] == 0 and milling["gouge_check"]["places"] > 100
    assert milling["loops"] > 0 and milling["phases"]["roughing"]["steps"] >= 5 and report["print_time_s"] == milling["time_s"] > 10
    assert abs(milling["removed_mm3"] - (22 * 12 * 5 - 20 * 10 * 4)) < 30, milling["removed_mm3"]
    assert min(numbers(text, "Z")) == 7 and max(numbers(text, "Z")) == 17
    assert 96 < min(numbers(text, "X")) < 100 and 120 < max(numbers(text, "X")) < 124
    assert "T1 M6" in text and "\nM2\n" in text and "; cutter = cyl:4\n" in text
    text = mill(program, box, folder / "top.nc", "cutter=cyl:4", "origin=stock_top", "dialect=grbl", "arcs=0", "spindle=9000", "coolant=mist")
    assert max(numbers(text, "Z")) == 5 and min(numbers(text, "Z")) == -5 and "M6" not in text and "S9000 M3" in text and "M7" in text
    assert not re.search(r"^G[23]\b", text, re.M)


def check_stock(program, models, folder):
    part = write_box(folder / "part.obj", (20, 10, 4))
    blank = write_box(folder / "blank.obj", (30, 16, 6))
    mill(program, part, folder / "stock.nc", "cutter=cyl:4", "stock=blank.obj", report=folder / "stock.json", more=(blank,))
    milling = json.loads((folder / "stock.json").read_text())["milling"]
    assert milling["stock"] == {"min_mm": [-5, -3, 0], "max_mm": [25, 13, 6]}, milling["stock"]


def check_copies(program, models, folder):
    part = write_box(folder / "part.obj", (20, 10, 4))
    mill(program, part, folder / "two.nc", "cutter=cyl:4", report=folder / "two.json", more=("--copies", "part.obj=2"))
    part = json.loads((folder / "two.json").read_text())["milling"]["part"]
    assert max(b - a for a, b in zip(part["min_mm"], part["max_mm"])) >= 30, part


def check_pictures(program, models, folder):
    model = models / "textbox.stl"
    mill(program, model, folder / "text.nc", *COARSE[1::2])
    svg = mill(program, model, folder / "level.svg", *COARSE[1::2], "output_step=3")
    assert svg.startswith("<svg") and svg.count("<path") > 1
    for arguments in ([], ["--layer", "1"], ["--layer", "1", "--color", "order", "--travels"]):
        must(program, "render", folder / "text.nc", *arguments, "-o", folder / "ways.png")
        assert (folder / "ways.png").stat().st_size > 2000
    done = run(program, "render", folder / "text.nc", "--layer", "999", "-o", folder / "none.png")
    assert done.returncode != 0 and "levels" not in done.stdout and "level 999" in done.stderr, done.stderr


def check_refusals(program, models, folder):
    box = write_box(folder / "box.obj", (20, 10, 4))
    opened = write_box(folder / "open.obj", (20, 10, 4), lid=False)
    for model, settings, words in (
            (box, ["cutter=drill:6"], "bull:D:CORNER"),
            (box, ["cutter=cyl:60"], "wider than the stock"),
            (box, ["cutter=conecone:2:20:60:6"], "steeper"),
            (box, ["cutter=cyl:4", "bottom=9"], "no level of the part"),
            (box, ["cutter=cyl:4", "tool_length=3"], "3 mm long"),
            (box, ["cutter=cyl:4", "stock=blank.obj"], "is the name of no object"),
            (box, ["cutter=cyl:4", "output_format=svg", "output_step=99999"], "output_step"),
            (box, ["perimeters=3"], "process fdm"),
            (opened, ["cutter=cyl:4"], "not closed")):
        pairs = [part for setting in settings for part in ("--set", setting)]
        bad = folder / ("bad.svg" if "output_format=svg" in settings else "bad.nc")
        done = run(program, "slice", model, "-o", bad, "--machine", "mill", *pairs)
        assert done.returncode not in (0, 1) and words in done.stderr, f"{settings}: {done.returncode} {done.stderr}"
        assert not bad.exists()
    mill(program, opened, folder / "open.nc", "cutter=cyl:4", "open_mesh=1")


def check_interpreter(program, models, folder):
    """Checks that LinuxCNC's own interpreter reads the programs."""
    rs274 = shutil.which("rs274")
    if rs274 is None:
        print("rs274 is not installed (linuxcnc-uspace): programs are not read by it")
        return
    for settings in (["entry=helix"], ["entry=ramp", "arcs=0"]):
        mill(program, models / "textbox.stl", folder / "rs.ngc", *COARSE[1::2], *settings)
        done = run(rs274, "-g", folder / "rs.ngc")
        assert done.returncode == 0 and "error" not in done.stderr.lower(), done.stderr[-2000:]


def check_stock_of_farm(farm, program, folder):
    """Checks a blank that is wider than the table."""
    models = [write_box(folder / "part.obj", (20, 10, 4)), write_box(folder / "blank.obj", (30, 16, 6))]
    given = ["--machine", "mill", *COARSE, "--set", "stock=blank.obj", "--set", "bed_shape=0x0,25x0,25x25,0x25"]
    must(program, "slice", *models, "-o", folder / "here.nc", "-q", *given)
    done = farm.client("submit", *models, "-o", folder / "there.nc", "-q", *given)
    assert done.returncode == 0, done.stderr
    assert (folder / "there.nc").read_bytes() == (folder / "here.nc").read_bytes()


def check_farm(program, models, folder):
    """Checks that a farm produces the same bytes as the command line, with fused workers and with split stages, while
    some of them are killed.
    """
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    model = models / "textbox.stl"
    given = ["--machine", "mill", *COARSE, "--copies", "textbox.stl=2"]
    must(program, "slice", model, "-o", folder / "here.nc", "-q", *given)
    here = (folder / "here.nc").read_bytes()
    for split in (False, True):
        with running_farm(split=split) as farm:
            waiting = farm.client("submit", model, "--detach", "-q", *given)
            assert waiting.returncode == 0, waiting.stderr
            killed = farm.workers[0] if not split else next(s for s in farm.services if s.name.startswith("milling"))
            for _ in range(2):
                killed.kill()
                killed.start()
            job = waiting.stdout.strip()
            done = farm.client("watch", job)
            assert done.returncode == 0, done.stderr
            done = farm.client("get", job, "-o", folder / "there.nc")
            assert done.returncode == 0, done.stderr
            assert (folder / "there.nc").read_bytes() == here, f"split {split}"
            check = farm.client("submit", model, "--check", *given)
            assert check.returncode == 0, check.stderr
            check_stock_of_farm(farm, program, folder)


def main(program, models):
    with tempfile.TemporaryDirectory() as name:
        for check in (check_program, check_stock, check_copies, check_pictures, check_refusals, check_interpreter, check_farm):
            check(program, pathlib.Path(models), pathlib.Path(name))
            print(f"{check.__name__}: ok")


if __name__ == "__main__":
    main(*sys.argv[1:])
