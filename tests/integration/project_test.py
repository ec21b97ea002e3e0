#!/usr/bin/env python3
"""Tests 3MF projects in the layouts of PrusaSlicer, Bambu Studio and CAD programs, from file to G-code. Objects,
positions, settings, parts, modifiers, height ranges, copies, plates and painted seams must be those of the file. A
damaged or hostile file must end in an error that names the file.

usage: project_test.py SLICEFARM
"""
import collections
import itertools
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "bench"))
from seams import read_layers

CORE = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
PRODUCTION = "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
BED = "0x0,256x0,256x256,0x256"
WIDTHS = ["--set", "external_perimeter_extrusion_width=0.45", "--set", "first_layer_extrusion_width=0.45"]
NO_PLATE, BAD_SETTINGS, BAD_MESH = 2, 3, 4  # exit codes

Beads = collections.namedtuple("Beads", "box heights features")


def cube(x, y, z, side):
    corners = [(x + a * side, y + b * side, z + c * side) for c in (0, 1) for b in (0, 1) for a in (0, 1)]
    faces = [(0, 2, 1), (1, 2, 3), (4, 5, 6), (5, 7, 6), (0, 1, 4), (1, 5, 4), (2, 6, 3), (3, 6, 7), (0, 4, 2), (2, 4, 6), (1, 3, 5), (3, 7, 5)]
    return corners, faces


def paint_code(triangle, state, size):
    """Returns a triangle's paint in the slicers' code. All edges are halved until the longest is at most `size`.
    state(x, y, z): 0 none, 1 enforced, 2 blocked.
    """
    if max(math.dist(p, q) for p, q in itertools.combinations(triangle, 2)) <= size:
        return "048"[state(*(sum(axis) / 3 for axis in zip(*triangle)))]
    a, b, c = triangle
    ab, bc, ca = (tuple((i + j) / 2 for i, j in zip(p, q)) for p, q in ((a, b), (b, c), (c, a)))
    parts = [paint_code(part, state, size) for part in ((a, ab, ca), (ab, b, bc), (bc, c, ca), (ab, bc, ca))]
    return parts[0] if set(parts) in ({"0"}, {"4"}, {"8"}) else "".join(parts) + "3"


def painted(xml, state, attribute):
    """Returns `xml`, which has one mesh, with paint on the triangles of the mesh."""
    corners = [tuple(map(float, xyz)) for xyz in re.findall(r'<vertex x="(.*?)" y="(.*?)" z="(.*?)"/>', xml)]

    def paint(match):
        code = paint_code([corners[int(i)] for i in match.groups()], state, 1)
        return match[0] if code == "0" else match[0].replace("/>", f' {attribute}="{code}"/>')
    return re.sub(r'<triangle v1="(\d+)" v2="(\d+)" v3="(\d+)"/>', paint, xml)


def mesh_xml(*meshes):
    corners, faces = [], []
    for more, triangles in meshes:
        faces += [tuple(i + len(corners) for i in t) for t in triangles]
        corners += more
    vertices = "".join(f'<vertex x="{x}" y="{y}" z="{z}"/>' for x, y, z in corners)
    triangles = "".join(f'<triangle v1="{a}" v2="{b}" v3="{c}"/>' for a, b, c in faces)
    return f"<mesh><vertices>{vertices}</vertices><triangles>{triangles}</triangles></mesh>"


def model_xml(objects, items, application):
    return (f'<?xml version="1.0"?><model unit="millimeter" xmlns="{CORE}" xmlns:p="{PRODUCTION}">'
            f'<metadata name="Application">{application}</metadata><resources>{objects}</resources><build>{items}</build></model>')


def item(number, x, y, turned=False, more=""):
    linear = "0 1 0 -1 0 0 0 0 1" if turned else "1 0 0 0 1 0 0 0 1"
    return f'<item objectid="{number}" transform="{linear} {x} {y} 0" {more}/>'


def prusa_files():
    """Returns a project with two copies of a block of 20 mm with a modifier, the second copy rotated, and a post with
    layers of 0.1 mm in the middle of its height.
    """
    objects = (f'<object id="1" type="model">{mesh_xml(cube(0, 0, 0, 20), cube(5, 5, 0, 10))}</object>'
               f'<object id="2" type="model">{mesh_xml(cube(-3, -3, 0, 6))}</object>')
    return {
        "3D/3dmodel.model": model_xml(objects, item(1, 50, 60) + item(1, 120, 60, True) + item(2, 30, 30) + item(2, 200, 200, more='printable="0"'),
                                      "PrusaSlicer-2.9.2"),
        "Metadata/Slic3r_PE.config": f"; layer_height = 0.25\n; first_layer_height = 0.25\n; fill_density = 0%\n; bed_shape = {BED}\n"
                                     "; top_solid_layers = 0\n; bottom_solid_layers = 0\n; gcode_label_objects = octoprint\n",
        "Metadata/Slic3r_PE_model.config": """<config><object id="1"><metadata type="object" key="name" value="Block"/>
<metadata type="object" key="perimeters" value="3"/>
<volume firstid="0" lastid="11"><metadata type="volume" key="name" value="body"/><metadata type="volume" key="volume_type" value="ModelPart"/></volume>
<volume firstid="12" lastid="23"><metadata type="volume" key="name" value="denser"/>
<metadata type="volume" key="volume_type" value="ParameterModifier"/><metadata type="volume" key="fill_density" value="40%"/></volume></object>
<object id="2"><metadata type="object" key="name" value="Post"/></object></config>""",
        "Metadata/Prusa_Slicer_layer_config_ranges.xml": '<objects><object id="2"><range min_z="2" max_z="4"><option opt_key="layer_height">0.1'
                                                         "</option></range></object></objects>"}


def bambu_files():
    """Returns a project with two plates. The first has a block with a hole, the second has the same block. The parts are in
    a separate file.
    """
    parts = ('<components><component p:path="/3D/Objects/o.model" objectid="1"/>'
             '<component p:path="/3D/Objects/o.model" objectid="2"/></components>')
    settings = {"layer_height": "0.2", "initial_layer_print_height": "0.2", "printable_area": ["0x0", "256x0", "256x256", "0x256"],
                "gcode_flavor": "marlin", "sparse_infill_density": "0%", "top_shell_layers": "0", "bottom_shell_layers": "0", "wall_loops": "2", "nozzle_diameter": ["0.4"],
                "gcode_label_objects": "1"}
    plate = ('<plate><metadata key="plater_id" value="{0}"/><metadata key="plater_name" value="plate {0}"/>'
             '<model_instance><metadata key="object_id" value="3"/><metadata key="instance_id" value="{1}"/></model_instance></plate>')
    return {
        "3D/3dmodel.model": model_xml(f'<object id="3" type="model">{parts}</object>', item(3, 100, 110) + item(3, 100 + 1.2 * 256, 120),
                                      "BambuStudio-02.00.01.50"),
        "3D/Objects/o.model": model_xml(f'<object id="1">{mesh_xml(cube(-10, -10, 0, 20))}</object>'
                                        f'<object id="2">{mesh_xml(cube(-2.5, -2.5, -1, 5))}</object>', "", ""),
        "Metadata/project_settings.config": json.dumps(settings),
        "Metadata/model_settings.config":
            '<config><object id="3"><metadata key="name" value="Block"/><part id="1" subtype="normal_part"><metadata key="name" value="body"/></part>'
            '<part id="2" subtype="negative_part"><metadata key="name" value="pit"/></part></object>' + plate.format(1, 0) + plate.format(2, 1) +
            "</config>"}


def cad_files():
    return {"3D/3dmodel.model": model_xml(f'<object id="1">{mesh_xml(cube(1000, -500, 7, 20))}</object>', '<item objectid="1"/>', "CAD")}


def write(path, files):
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return str(path)


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=300)


def must(program, *arguments):
    result = run(program, *arguments)
    assert result.returncode == 0, f"{arguments}: {result.stderr}"
    return result.stdout


def sliced(program, folder, project, *arguments):
    """Returns for each label the box around the centre lines of its outer walls in um, and the heights of its layers."""
    must(program, "slice", project, "-o", folder / "out.gcode", "--report", folder / "report.json", "-q", *arguments)
    label, feature, at, z, found = None, "", (0, 0), 0, {}
    for line in (folder / "out.gcode").read_text().splitlines():
        if line.startswith("; printing object "):
            label = line.removeprefix("; printing object ")
            found.setdefault(label, Beads([10**9, 10**9, -10**9, -10**9], set(), collections.Counter()))
        feature = line[6:] if line.startswith(";TYPE:") else feature
        if not line.startswith("G1 "):
            continue
        words = {letter: round(float(value) * 1000) for letter, value in re.findall(r"([XYZE])(-?\d*\.?\d+)", line)}
        z, before = words.get("Z", z), at
        at = (words.get("X", at[0]), words.get("Y", at[1]))
        if words.get("E", 0) > 0 and at != before:
            beads = found[label]
            beads.heights.add(z)
            beads.features[feature] += 1
            if feature == "External perimeter":
                for x, y in (before, at):
                    beads.box[:] = min(beads.box[0], x), min(beads.box[1], y), max(beads.box[2], x), max(beads.box[3], y)
    return found


def assert_box(beads, x0, y0, x1, y1):
    """Checks the box of a part, in mm; walls are half a line of 0.45 mm inside it."""
    want = [x0 + 0.225, y0 + 0.225, x1 - 0.225, y1 - 0.225]
    assert all(abs(got / 1000 - mm) <= 0.011 for got, mm in zip(beads.box, want)), f"{beads.box} and not {want}"


def check_prusa(program, folder):
    project = write(folder / "prusa.3mf", prusa_files())
    told = json.loads(must(program, "inspect", project))
    assert [o["name"] for o in told["objects"]] == ["Block", "Post"] and told["objects"][0]["parts"][1]["role"] == "modifier"
    found = sliced(program, folder, project, *WIDTHS)
    assert len(found) == 3, list(found)
    blocks = [beads for label, beads in found.items() if label.startswith("Block")]
    post, = (beads for label, beads in found.items() if label.startswith("Post"))
    assert_box(blocks[0], 50, 60, 70, 80)
    assert_box(blocks[1], 100, 60, 120, 80)
    assert_box(post, 27, 27, 33, 33)
    assert sorted(blocks[0].heights) == list(range(250, 20001, 250))
    assert 100 in {b - a for a, b in zip(sorted(post.heights), sorted(post.heights)[1:])}, sorted(post.heights)
    assert blocks[0].features["Internal infill"] > 0 and post.features["Internal infill"] == 0, "the modifier fills the block alone"
    assert "perimeters" in (folder / "out.gcode").read_text().split("object_settings = ")[1].splitlines()[0]


def check_bambu(program, folder):
    project = write(folder / "bambu.3mf", bambu_files())
    refused = run(program, "slice", project, "-o", folder / "out.gcode")
    assert refused.returncode == NO_PLATE and "plate 2" in refused.stderr and "bambu.3mf" in refused.stderr, refused.stderr
    assert run(program, "slice", project, "-o", folder / "out.gcode", "--plate", 3).returncode == NO_PLATE
    for plate, y in ((1, 110), (2, 120)):
        beads, = sliced(program, folder, project, "--plate", plate, *WIDTHS).values()
        assert_box(beads, 90, y - 10, 110, y + 10)
        assert sorted(beads.heights) == list(range(200, 20001, 200))
    walls = sum(beads.features.values())
    files = bambu_files()
    files["Metadata/model_settings.config"] = files["Metadata/model_settings.config"].replace("negative_part", "modifier_part")
    without, = sliced(program, folder, write(folder / "solid.3mf", files), "--plate", 2).values()
    assert walls > sum(without.features.values()), "the negative part cuts a pit, which has walls"


def check_cad(program, folder):
    project = write(folder / "cad.3mf", cad_files())
    plain = ["--set", f"bed_shape={BED}", "--set", "layer_height=0.2", "--set", "first_layer_height=0.2", "--set", "gcode_label_objects=octoprint", *WIDTHS]
    beads, = sliced(program, folder, project, *plain).values()
    assert_box(beads, 118, 118, 138, 138)
    beads, = sliced(program, folder, project, "--scale", 2, "--center", "60,70", *plain).values()
    assert_box(beads, 40, 50, 80, 90)
    assert max(beads.heights) == 40000
    assert len(sliced(program, folder, project, "--copies", "cad.3mf=3", *plain)) == 3


def check_what_has_no_effect(program, folder):
    files = prusa_files()
    files["Metadata/Slic3r_PE.config"] += "; post_process = /bin/evil\n; no_such_setting = 3\n"
    sliced(program, folder, write(folder / "told.3mf", files))
    told = "\n".join(json.loads((folder / "report.json").read_text())["settings_without_effect"])
    assert "scripts" in told and "no_such_setting" in told, told
    assert "evil" not in (folder / "out.gcode").read_text()
    files = painted_files(lambda x, y, z: 1 if x < 1e-6 else 0, "slic3rpe:fuzzy_skin")
    files["Metadata/Slic3r_PE.config"] += "; colorprint_heights = 5\n; host_type = prusalink\n"
    files["Metadata/thumbnail.png"] = "no picture"
    project = write(folder / "weights.3mf", files)
    refused = run(program, "slice", project, "-o", folder / "out.gcode")
    assert refused.returncode == BAD_SETTINGS and "--allow colorprint_heights" in refused.stderr, refused.stderr
    allowed = run(program, "slice", project, "-o", folder / "out.gcode", "--allow", "colorprint_heights", "--generic")
    lines = allowed.stderr.splitlines()
    assert [line.split(":")[1].split()[0] for line in lines] == ["colorprint_heights", "painted"], lines


def painted_files(state, attribute):
    """Returns a project with two painted copies of a block of 20 mm, the second copy rotated."""
    mesh = painted(mesh_xml(cube(0, 0, 0, 20)), state, attribute)
    return {"3D/3dmodel.model": model_xml(f'<object id="1" type="model">{mesh}</object>', item(1, 50, 60) + item(1, 120, 60, True), "PrusaSlicer-2.9.2"),
            "Metadata/Slic3r_PE.config": f"; bed_shape = {BED}\n; layer_height = 0.25\n; first_layer_height = 0.25\n; seam_position = aligned\n"}


def seams_of(gcode):
    """Returns the starts of the outer walls of all layers in the block's own coordinates, for each of the two copies.
    The copies are distinguished by their position.
    """
    straight, turned = [], []
    for _, loops in read_layers(gcode):
        for loop in loops:
            x, y = loop[0]
            if x < 80:
                straight.append((x - 50, y - 60))
            else:
                turned.append((y - 60, 120 - x))
    return straight, turned


def check_paint(program, folder):
    """Checks that in each layer of each copy the seam is in the enforced stripe and never in a blocked area."""
    def stripe(x, y, z):
        return 1 if y < 1e-6 and 5 < x < 9 else 0

    def corners(x, y, z):
        return 2 if abs(x - 10) > 5 and abs(y - 10) > 5 else 0

    for attribute in ("slic3rpe:custom_seam", "paint_seam"):
        project = write(folder / "painted.3mf", painted_files(stripe, attribute))
        told = json.loads(must(program, "inspect", project))
        assert [part["role"] for part in told["objects"][0]["parts"]] == ["solid", "seam_enforcer"] and not told["without_effect"], told
        must(program, "slice", project, "-o", folder / "out.gcode", "--report", folder / "report.json", "-q")
        assert not json.loads((folder / "report.json").read_text())["warnings"], "a painted surface is no broken mesh"
        for seams in seams_of(folder / "out.gcode"):
            assert len(seams) == 80 and all(6 < x < 8 and y < 0.5 for x, y in seams), seams
    write(folder / "painted.3mf", painted_files(corners, "paint_seam"))
    must(program, "slice", folder / "painted.3mf", "-o", folder / "out.gcode", "-q")
    for seams in seams_of(folder / "out.gcode"):
        assert len(seams) == 80 and not any(corners(x, y, 0) for x, y in seams), seams


def check_hostile(program, folder):
    def with_model(text):
        return {"3D/3dmodel.model": text}

    model = cad_files()["3D/3dmodel.model"]
    laughs = "".join(f'<!ENTITY a{i} "{f"&a{i - 1};" * 10}">' for i in range(1, 9))
    loop = '<object id="1"><components><component objectid="2"/></components></object><object id="2"><components><component objectid="1"/></components></object>'
    cases = {
        "cut": None,
        "empty": {},
        "entities": with_model(f'<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a0 "ha">{laughs}]><model xmlns="{CORE}">&a8;</model>'),
        "bomb": with_model(model + " " * 300_000_000),
        "loop": with_model(model_xml(loop, '<item objectid="1"/>', "")),
        "deep": with_model("<a>" * 100_000),
        "paths": {"../../etc/passwd": "x", **cad_files()},
        "entries": {**cad_files(), **{f"f{i}": "" for i in range(2000)}},
        "no_such_object": with_model(model.replace('objectid="1"', 'objectid="7"')),
        "paint": with_model(model.replace('v1="0"', 'paint_seam="3" v1="0"', 1)),
        "no_such_corner": with_model(model.replace('v1="0"', 'v1="99"', 1)),
        "nan": with_model(model.replace('x="1000"', 'x="nan"', 1)),
        "nothing": with_model(model_xml("", "", ""))}
    for name, files in cases.items():
        path = folder / f"{name}.3mf"
        if files is None:
            path.write_bytes(pathlib.Path(write(folder / "whole.3mf", cad_files())).read_bytes()[:200])
        else:
            write(path, files)
        for command in (["slice", path, "-o", folder / "bad.gcode"], ["inspect", path]):
            result = run(program, *command)
            if command[0] == "inspect" and name in ("no_such_corner", "nan"):
                continue  # the structure does not show this fault
            assert result.returncode == BAD_MESH, f"{name}: {result.returncode} {result.stderr}"
            assert f"{name}.3mf" in result.stderr, f"{name}: {result.stderr}"
    assert not (folder / "bad.gcode").exists()


def check_farm(program, folder):
    """Checks that a farm of real processes, which reads the file in a sandbox, produces the same bytes. Checks a file
    whose fault only the farm detects.
    """
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    project = write(folder / "prusa.3mf", prusa_files())
    must(program, "slice", project, "-o", folder / "here.gcode", "--report", folder / "here.json")
    paint = write(folder / "painted.3mf", painted_files(lambda x, y, z: 1 if x < 1e-6 and y < 9 else 0, "paint_seam"))
    must(program, "slice", paint, "-o", folder / "painted_here.gcode")
    broken = cad_files()
    broken["3D/3dmodel.model"] = broken["3D/3dmodel.model"].replace('v1="0"', 'v1="99"', 1)
    with running_farm() as farm:
        done = farm.client("submit", project, "-o", folder / "there.gcode", "--report", folder / "there.json")
        assert done.returncode == 0, done.stderr
        done = farm.client("submit", paint, "-o", folder / "painted_there.gcode")
        assert done.returncode == 0, done.stderr
        refused = farm.client("submit", write(folder / "broken.3mf", broken), "-o", folder / "bad.gcode")
        plate = farm.client("submit", write(folder / "bambu.3mf", bambu_files()), "--plate", "2", "-o", folder / "plate.gcode")
    assert (folder / "here.gcode").read_bytes() == (folder / "there.gcode").read_bytes()
    assert (folder / "painted_here.gcode").read_bytes() == (folder / "painted_there.gcode").read_bytes()
    here, there = (json.loads((folder / name).read_text())["settings_without_effect"] for name in ("here.json", "there.json"))
    assert here == there, f"{here} and {there}"
    assert refused.returncode == BAD_MESH and "broken.3mf" in refused.stderr, refused.stderr
    assert plate.returncode == 0, plate.stderr


def main(program):
    with tempfile.TemporaryDirectory() as name:
        for check in (check_prusa, check_bambu, check_cad, check_paint, check_what_has_no_effect, check_hostile, check_farm):
            check(program, pathlib.Path(name))
            print(f"{check.__name__}: ok")


if __name__ == "__main__":
    main(*sys.argv[1:])
