#!/usr/bin/env python3
"""Tests .gcode.3mf archives with an independent reader (Python's zipfile and XML):

- the archive has all files of Bambu Studio's archives, the MD5 of its program, and facts that equal the report's;
- the program equals the one of the .gcode file except for the block of facts and labels of copies;
- a pixel of the pick picture has the id of the copy whose box contains it, and the program's labels have the same ids;
- the bytes are the same for any number of threads, on another day, and from a farm;
- several plates make one archive; render, time and check read each of them;
- files that are no archives, bombs and damaged archives are refused by their names.

usage: gcode_3mf_test.py SLICEFARM MODELS
"""
import hashlib
import io
import json
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zipfile
import zlib

COMMON = ["-q", "--set", "layer_height=0.3", "--set", "fill_density=8%", "--set", "filament_density=1.24", "--set", "bed_shape=0x0,256x0,256x256,0x256",
          "--set", "nozzle_diameter=0.4"]
PRINTERS = {
    "bambu": ["--set", "gcode_flavor=bambu", "--set", "gcode_label_objects=firmware", "--set", "printer_model=Bambu Lab X1 Carbon"],
    "klipper": ["--set", "gcode_flavor=klipper", "--set", "gcode_label_objects=firmware"],
    "marlin": ["--set", "gcode_flavor=marlin2", "--set", "binary_gcode=1"],
}
MEMBERS = {"[Content_Types].xml", "_rels/.rels", "3D/3dmodel.model", "Metadata/_rels/model_settings.config.rels", "Metadata/model_settings.config",
           "Metadata/project_settings.config", "Metadata/slice_info.config"}
PLATE_MEMBERS = ["plate_#.gcode", "plate_#.gcode.md5", "plate_#.json", "plate_#.png", "plate_#_small.png", "plate_no_light_#.png", "top_#.png", "pick_#.png"]


def run(*command):
    return subprocess.run([str(word) for word in command], capture_output=True, text=True)


def sliced(program, output, *arguments):
    done = run(program, "slice", *COMMON, *arguments, "-o", output)
    assert done.returncode == 0, done.stderr
    return output


def members_of(plates):
    return MEMBERS | {"Metadata/" + name.replace("#", str(number)) for number in range(1, plates + 1) for name in PLATE_MEMBERS}


def pixels(png):
    """Returns width and rows of RGBA pixels. Handles 8-bit RGBA without interlacing."""
    assert png.startswith(b"\x89PNG\r\n\x1a\n")
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        body = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", body)
            assert (depth, colour, interlace) == (8, 6, 0)
        data += body if kind == b"IDAT" else b""
        at += size + 12
    raw, rows, before = zlib.decompress(data), [], bytes(4 * width)
    for y in range(height):
        line = raw[y * (4 * width + 1):(y + 1) * (4 * width + 1)]
        method, row = line[0], bytearray(line[1:])
        for i in range(len(row)):
            left, up, corner = row[i - 4] if i >= 4 else 0, before[i], before[i - 4] if i >= 4 else 0
            if method == 1:
                row[i] = row[i] + left & 255
            elif method == 2:
                row[i] = row[i] + up & 255
            elif method == 3:
                row[i] = row[i] + (left + up) // 2 & 255
            elif method == 4:
                nearest = min((abs(up - corner), 0, left), (abs(left - corner), 1, up), (abs(left + up - 2 * corner), 2, corner))
                row[i] = row[i] + nearest[2] & 255
        before = bytes(row)
        rows.append([before[x:x + 4] for x in range(0, len(before), 4)])
    return width, rows


def facts_of(archive, plate=1):
    root = xml.etree.ElementTree.fromstring(archive.read("Metadata/slice_info.config"))
    element = root.findall("plate")[plate - 1]
    return {meta.get("key"): meta.get("value") for meta in element.findall("metadata")}, element


def check_pick(archive, bed_mm=256):
    plate = json.loads(archive.read("Metadata/plate_1.json"))
    width, rows = pixels(archive.read("Metadata/pick_1.png"))
    boxes = {each["id"]: each["bbox"] for each in plate["bbox_objects"]}
    seen = dict.fromkeys(boxes, 0)
    for y, row in enumerate(rows):
        for x, (red, green, blue, alpha) in enumerate(row):
            if alpha == 0:
                continue
            number = red | green << 8 | blue << 16
            seen[number] += 1  # KeyError: a pixel has an id that no copy has
            at_x, at_y, slack = (x + 0.5) * bed_mm / width, bed_mm - (y + 0.5) * bed_mm / width, 1
            left, front, right, back = boxes[number]
            assert left - slack <= at_x <= right + slack and front - slack <= at_y <= back + slack, (number, at_x, at_y, boxes[number])
    assert all(count > 50 for count in seen.values()), seen
    return seen


def without_ids(gcode):
    """Returns the lines without the block of facts, labels, and the quoted settings of the file's format."""
    for block in ("HEADER", "CONFIG"):
        gcode = re.sub(rf"^; {block}_BLOCK_START\n.*?; {block}_BLOCK_END\n\n", "", gcode, flags=re.M | re.S)
    numbered = re.compile(r"label id: [\d,]+|EXCLUDE_OBJECT_\w+ NAME=\S+|; (gcode_3mf|binary_gcode|thumbnails) = .*")
    return [numbered.sub("", line) for line in gcode.splitlines()]


def check_printer(program, models, folder, name, settings):
    three = [models / "busted.stl", models / "textbox.stl", "--copies", "busted.stl=2"]
    file, report_file = folder / f"{name}.gcode.3mf", folder / f"{name}.json"
    sliced(program, file, *three, *settings, "--report", report_file, "--threads", 2)
    report = json.loads(report_file.read_text())
    with zipfile.ZipFile(file) as archive:
        assert archive.testzip() is None and set(archive.namelist()) == members_of(1), archive.namelist()
        gcode = archive.read("Metadata/plate_1.gcode")
        assert archive.read("Metadata/plate_1.gcode.md5").decode() == hashlib.md5(gcode).hexdigest().upper()
        facts, element = facts_of(archive)
        assert int(facts["prediction"]) == round(report["print_time_s"]) and abs(float(facts["weight"]) - report["filament"]["g"]) < 0.006
        assert facts["printer_model_id"] == ("BL-P001" if name == "bambu" else "") and facts["nozzle_diameters"] == "0.4"
        assert facts["label_object_enabled"] == str(name != "marlin").lower()
        objects = [(int(each.get("identify_id")), each.get("name"), each.get("skipped")) for each in element.findall("object")]
        assert objects == [(1, "busted.stl", "false"), (2, "busted.stl", "false"), (3, "textbox.stl", "false")], objects
        filament = element.find("filament")
        assert filament.get("type") == "PLA" and abs(float(filament.get("used_m")) - report["filament"]["mm"] / 1000) < 0.006
        assert len(element.findall("warning")) == len(report["warnings"])
        project = json.loads(archive.read("Metadata/project_settings.config"))
        assert project["layer_height"] == "0.3" and project["filament_type"] == ["PLA"] and project["nozzle_diameter"] == ["0.4"], project
        for document in ("Metadata/model_settings.config", "3D/3dmodel.model", "[Content_Types].xml", "_rels/.rels"):
            xml.etree.ElementTree.fromstring(archive.read(document))
        for info in archive.infolist():
            assert info.date_time == (1980, 1, 1, 0, 0, 0), info
        covered = check_pick(archive)
        assert covered[1] == covered[2] or abs(covered[1] - covered[2]) < 0.1 * covered[1]
    text = gcode.decode()
    assert re.search(r"^; total layer number: " + str(report["layers"]) + "$", text, re.M)
    block = dict(re.findall(r"^; (\S+) = (.*)$", text[text.index("; CONFIG_BLOCK_START"):text.index("; CONFIG_BLOCK_END")], re.M))
    assert block["layer_height"] == "0.3" and block["nozzle_temperature"] == "200" and block["sparse_infill_density"] == "8%", block
    if name == "bambu":
        assert "; model label id: 1,2,3\n" in text and {1, 2, 3} == {int(i) for i in re.findall(r"start printing object, unique label id: (\d+)", text)}
    plain = sliced(program, folder / f"{name}.gcode", *three, *settings, "--format", "gcode").read_text()
    assert without_ids(text) == without_ids(plain), next(pair for pair in zip(without_ids(text), without_ids(plain)) if pair[0] != pair[1])
    again = sliced(program, folder / f"{name}-again.gcode.3mf", *three, *settings, "--threads", 1)
    assert again.read_bytes() == file.read_bytes(), "the bytes depend on the threads"
    return file, plain, report


def check_readers(program, folder, file, plain, report, flavor):
    text = folder / "plain.gcode"
    text.write_text(plain)
    for command in ("time", "check"):
        answers = [run(program, command, each, "--flavor", flavor) for each in (file, text)]
        assert [answer.returncode for answer in answers][0] in (0, 1), answers[0].stderr
        if command == "check":
            answers = [re.sub(r"lines \d+\n|line \d+: ", "", answer.stdout) for answer in answers]
        else:
            answers = [answer.stdout for answer in answers]
        assert answers[0] == answers[1] and len(answers[0]) > 50, (command, answers)
    pictures = []
    for each in (file, text):
        picture = folder / f"{len(pictures)}.png"
        done = run(program, "render", each, "--layer", 3, "-o", picture)
        assert done.returncode == 0, done.stderr
        pictures.append(picture.read_bytes())
    assert pictures[0] == pictures[1]
    assert run(program, "render", text, "--layer", 3, "--plate", 2, "-o", folder / "no.png").returncode == 2


def check_plates(program, models, folder):
    file = sliced(program, folder / "many.gcode.3mf", models / "busted.stl", "--copies", "busted.stl=30", "--plates", "--report", folder / "many.json",
                  "--set", "bed_shape=0x0,70x0,70x70,0x70")
    reports = [json.loads(path.read_text()) for path in sorted(folder.glob("many-*.json"))]
    assert len(reports) > 1 and not list(folder.glob("many-*.gcode.3mf"))
    with zipfile.ZipFile(file) as archive:
        assert set(archive.namelist()) == members_of(len(reports))
        for number, report in enumerate(reports, 1):
            gcode = archive.read(f"Metadata/plate_{number}.gcode")
            assert archive.read(f"Metadata/plate_{number}.gcode.md5").decode() == hashlib.md5(gcode).hexdigest().upper()
            facts, _ = facts_of(archive, number)
            assert facts["index"] == str(number) and int(facts["prediction"]) == round(report["print_time_s"])
        settings = archive.read("Metadata/model_settings.config").decode()
        for name in re.findall(r'value="(Metadata/[^"]*)"', settings):
            assert name in archive.namelist(), name
    refused = run(program, "time", file, "--flavor", "marlin")
    assert refused.returncode == 2 and "--plate" in refused.stderr, refused.stderr
    times = [json.loads(run(program, "time", file, "--flavor", "marlin", "--plate", n, "--json").stdout)["time_s"] for n in (1, len(reports))]
    for seconds, report in zip(times, (reports[0], reports[-1])):
        assert abs(seconds - report["print_time_s"]) < 0.02 * seconds, (seconds, report["print_time_s"])
    assert run(program, "render", file, "--plate", len(reports), "--layer", 2, "-o", folder / "p.png").returncode == 0
    assert run(program, "check", file, "--plate", len(reports) + 1, "--flavor", "marlin").returncode == 2


def check_hostile(program, models, folder, file):
    def with_file(name, data):
        stream = io.BytesIO(file.read_bytes())
        with zipfile.ZipFile(stream) as archive:
            members = {each: archive.read(each) for each in archive.namelist()}
        members[name] = data
        if data is None:
            del members[name]
        stream = io.BytesIO()
        with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
            for each, content in members.items():
                archive.writestr(each, content)
        return stream.getvalue()

    whole = file.read_bytes()
    at = whole.index(b"Metadata/plate_1.gcode", whole.index(b"Metadata/plate_1.gcode.md5") + 30) + 2000
    cases = {
        "no program": (with_file("Metadata/plate_1.gcode", None), "sliced"),
        "wrong checksum": (with_file("Metadata/plate_1.gcode.md5", b"0" * 32), "MD5"),
        "changed program": (with_file("Metadata/plate_1.gcode", b"G28\n"), "MD5"),
        "cut off": (whole[:-100], "damaged"),
        "flipped bit": (whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:], "plate_1.gcode"),
        "a head only": (b"PK\x03\x04" + bytes(100), "damaged"),
        "a model": (zip_of({"3D/3dmodel.model": b"<model/>"}), "sliced"),
    }
    bad = folder / "bad.gcode.3mf"
    for name, (data, message) in cases.items():
        bad.write_bytes(data)
        for command in (["time", bad, "--flavor", "marlin"], ["check", bad, "--flavor", "marlin"], ["render", bad, "--layer", 1, "-o", folder / "x.png"]):
            told = run(program, *command)
            assert told.returncode == 2 and message in told.stderr and "bad.gcode.3mf" in told.stderr, (name, command[0], told)
    told = run(program, "slice", models / "busted.stl", "--generic", "-o", folder / "x.gcode", "--set", "gcode_3mf=1")
    assert told.returncode == 2 and "gcode_3mf" in told.stderr, told.stderr


def zip_of(members):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in members.items():
            archive.writestr(name, data)
    return stream.getvalue()


def check_farm(program, models, folder):
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    here = sliced(program, folder / "here.gcode.3mf", models / "busted.stl", *PRINTERS["bambu"])
    with running_farm() as farm:
        there = folder / "there.gcode.3mf"
        done = farm.client("submit", models / "busted.stl", *COMMON, *PRINTERS["bambu"], "-o", there, "--json")
        assert done.returncode == 0, done.stderr
        job = json.loads(done.stdout)
        assert len(job["result"]["objects"]) == 1
        listed = {each["artifact"]: each for each in json.loads(farm.client("artifacts", job["id"]).stdout)["artifacts"]}
        assert listed["ARTIFACT_GCODE"]["file_name"] == "busted.gcode.3mf" and listed["ARTIFACT_GCODE"]["media_type"] == "model/3mf", listed
        picture = folder / "picture.png"
        done = farm.client("artifacts", job["id"], "--kind", "thumbnail", "-o", picture)
        assert done.returncode == 0, done.stderr
    assert there.read_bytes() == here.read_bytes()
    with zipfile.ZipFile(here) as archive:
        assert picture.read_bytes() == archive.read("Metadata/plate_1.png")


def check_ids(program, models, folder):
    """The ids of filament and plate that presets of OrcaSlicer have are in the archive."""
    presets = {
        "machine/P": {"type": "machine", "nozzle_diameter": ["0.4"], "gcode_flavor": "marlin", "default_bed_type": "4",
                      "printable_area": ["0x0", "180x0", "180x180", "0x180"], "printable_height": "180"},
        "process/Q": {"type": "process", "layer_height": "0.3", "initial_layer_print_height": "0.3"},
        "filament/F": {"type": "filament", "filament_id": "GFA00", "filament_type": ["PLA"]}}
    for path, settings in presets.items():
        file = folder / "presets" / f"{path}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(json.dumps({"name": file.stem, "from": "User", **settings}))
    file = folder / "ids.gcode.3mf"
    sliced(program, file, models / "textbox.stl", "--presets", folder / "presets", "--printer", "P", "--process", "Q", "--filament", "F")
    with zipfile.ZipFile(file) as archive:
        assert facts_of(archive)[1].find("filament").get("tray_info_idx") == "GFA00"
        assert json.loads(archive.read("Metadata/plate_1.json"))["bed_type"] == "textured_plate"
        project = json.loads(archive.read("Metadata/project_settings.config"))
        assert project["filament_ids"] == ["GFA00"] and project["curr_bed_type"] == "Textured PEI Plate", project


def main():
    program, models = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for printer, settings in PRINTERS.items():
            file, plain, report = check_printer(program, models, folder, printer, settings)
            check_readers(program, folder, file, plain, report, printer)
            print(f"{printer}: {file.stat().st_size} bytes, {len(plain)} as text")
        check_ids(program, models, folder)
        check_plates(program, models, folder)
        check_hostile(program, models, folder, file)
        check_farm(program, models, folder)


main()
