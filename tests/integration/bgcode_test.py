#!/usr/bin/env python3
"""Tests binary_gcode = 1 on whole files, which the independent reader of bgcode.py reads back:

- the program equals the program of the text file, line by line, except for blanks in G1 lines and comments after
  commands;
- the metadata and the thumbnails equal those in the text file;
- the bytes are the same for any number of threads, and from a farm of real processes, at once or fetched later.

usage: bgcode_test.py SLICEFARM CORPUS
"""
import base64
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import bgcode

SETTINGS = ["layer_height=0.3", "thumbnails=16x16/QOI,40x30/PNG,24x24/JPG", "gcode_label_objects=firmware", "remaining_times=1",
            "filament_type=PETG", "printer_model=MK4S", "layer_gcode=M117 Layer [layer_num] of many; G1 here",
            "before_layer_gcode=  ; a comment with blanks before it", "start_gcode=G28 ; home\\nM862.3 P \"MK4S\"\\n\\nG1 x1 Y2 ; low"]
FORMS = {"plain": [], "absolute": ["use_relative_e_distances=0"], "commented": ["gcode_comments=1"], "by firmware": ["use_firmware_retraction=1"]}
FORMATS = {"thumbnail": 0, "thumbnail_JPG": 1, "thumbnail_QOI": 2}


def slice_model(program, model, output, settings, threads=1):
    sets = [word for setting in settings for word in ("--set", setting)]
    done = subprocess.run([program, "slice", model, "--generic", "-o", output, "-q", "--threads", str(threads), *sets], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stderr


def commands(text):
    """Yields the lines as a printer interprets them."""
    for line in text.splitlines():
        if line.startswith(";"):
            yield line
            continue
        line = line.split(";")[0].strip()
        if re.match(r"G\d", line):
            line = line.replace(" ", "")
        if line:
            yield line


def facts(text):
    """Returns the pictures, program, facts, settings and object list of a text file."""
    pictures = [(FORMATS[tag], int(w), int(h), base64.b64decode(re.sub(r"[;\s]", "", data)))
                for tag, w, h, data in re.findall(r"^; (thumbnail\w*) begin (\d+)x(\d+) \d+\n(.*?); thumbnail\w* end", text, re.M | re.S)]
    program, tail = re.split(r"\n(?=\n; filament used \[mm\])", text)
    program = program[re.search(r"^(M73|;TYPE:Custom)", program, re.M).start():] + "\n"
    known, settings = tail.split("; prusaslicer_config = begin\n")
    lines = lambda block: dict(re.findall(r"^; (.+?) = (.*)$", block, re.M))
    settings = lines(settings)
    del settings["prusaslicer_config"]
    return pictures, program, lines(known), settings, re.search(r"; objects_info = (.*)", text)[1]


def agrees(program, model, folder, form, settings):
    text_file, binary_file = folder / "a.gcode", folder / "a.bgcode"
    slice_model(program, model, text_file, [*SETTINGS, *settings])
    slice_model(program, model, binary_file, [*SETTINGS, *settings, "binary_gcode=1"], threads=2)
    data = binary_file.read_bytes()
    blocks = bgcode.read(data)
    of = {block.type: block for block in blocks}
    pictures, lines, known, wanted, objects = facts(text_file.read_text())

    got = list(commands(bgcode.text(blocks)))
    want = list(commands(lines))
    assert got == want, (form, next((g, w) for g, w in zip(got, want) if g != w))
    assert [(*b.parameters, b.data) for b in blocks if b.type == bgcode.THUMBNAIL] == pictures and len(pictures) == 3, form

    slicer = bgcode.entries(of[bgcode.SLICER_METADATA])
    assert slicer == {**wanted, "binary_gcode": "1"}, form
    assert bgcode.entries(of[bgcode.PRINT_METADATA]) == known, form
    printer = bgcode.entries(of[bgcode.PRINTER_METADATA])
    for key in ("printer_model", "filament_type", "nozzle_diameter", "bed_temperature", "temperature", "layer_height"):
        assert printer[key] == slicer[key], (form, key)
    for key in ("estimated printing time (normal mode)", "filament used [g]", "max_layer_z"):
        assert printer[key] == known[key], (form, key)
    assert printer["objects_info"] == objects, form
    assert bgcode.entries(of[bgcode.FILE_METADATA])["Producer"].startswith("slicefarm "), form

    gcode = [block for block in blocks if block.type == bgcode.GCODE]
    assert all(block.compression == 3 and block.parameters == [2] for block in gcode), form
    assert all(block.compression == 0 for block in blocks if block.type in (bgcode.FILE_METADATA, bgcode.PRINTER_METADATA, bgcode.PRINT_METADATA))
    again = folder / "b.bgcode"
    slice_model(program, model, again, [*SETTINGS, *settings, "binary_gcode=1"], threads=1)
    assert again.read_bytes() == data, f"{form}: the bytes depend on the threads"
    return text_file.stat().st_size, len(data)


def names_tell(program, model, folder):
    """Checks that the setting decides the format, as in PrusaSlicer. A file name of the other format is refused, unless
    --format states the wanted format.
    """
    for name, settings in (("c.bgcode", ["layer_height=0.3"]), ("c.gcode", ["layer_height=0.3", "binary_gcode=1"])):
        command = [program, "slice", model, "--generic", "-o", folder / name, *(word for each in settings for word in ("--set", each))]
        told = subprocess.run(command, capture_output=True, text=True)
        assert told.returncode == 2 and "binary_gcode" in told.stderr and not (folder / name).exists(), told.stderr
    assert slice_model(program, model, folder / "d.gcode", ["layer_height=0.3"]) == ""


def comes_from_a_farm(program, model, folder):
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    settings = ["--set", "layer_height=0.3", "--set", "binary_gcode=1"]
    slice_model(program, model, folder / "here.bgcode", settings[1::2])
    here = (folder / "here.bgcode").read_bytes()
    assert here.startswith(b"GCDE")
    with running_farm() as farm:
        done = farm.client("submit", model, "-o", folder / "there.bgcode", *settings)
        assert done.returncode == 0, done.stderr
        job = farm.client("submit", model, "--detach", *settings).stdout.strip()
        assert farm.client("watch", job).returncode == 0
        for output in (folder / "fetched.bgcode", str(folder / "named") + "/"):
            done = farm.client("get", job, "-o", output)
            assert done.returncode == 0, done.stderr
    for file in (folder / "there.bgcode", folder / "fetched.bgcode", folder / "named" / f"{pathlib.Path(model).stem}.bgcode"):
        assert file.read_bytes() == here, file


def main():
    program, corpus = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for form, settings in FORMS.items():
            text, binary = agrees(program, corpus / "thin_walls.stl", folder, form, settings)
            print(f"{form}: {text} bytes of text, {binary} of binary G-code")
        names_tell(program, corpus / "thin_walls.stl", folder)
        (folder / "named").mkdir()
        comes_from_a_farm(program, corpus / "thin_walls.stl", folder)


main()
