#!/usr/bin/env python3
"""Tests spiral vases, from mesh to G-code. Above the bottom there is one bead that rises all the time, without a
travel, a retraction or a step. Its plastic is that of one loop per layer, and its turns join continuously. Copies
are printed one after the other or refused. Layers that are not a single loop are reported. The bytes are the same
for any number of threads, and from a farm of real processes.

usage: vase_test.py SLICEFARM
"""
import math
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from project_test import must, run

BAD_SETTING = 3  # exit code
SETTINGS = {"spiral_vase": "1", "layer_height": "0.2", "first_layer_height": "0.2", "bottom_solid_layers": "4", "external_perimeter_extrusion_width": "0.5",
            "nozzle_diameter": "0.4", "skirts": "0", "gcode_resolution": "0.005", "use_relative_e_distances": "1", "overhangs": "0",
            "retract_length": "0.8", "cooling": "0"}
HEIGHT, LAYERS, BOTTOM = 10.0, 50, 4


def cone(sides=96, low=10.0, high=13.0):
    """Returns an STL of a solid vase, 10 mm high, that becomes wider upwards."""
    def ring(radius, z):
        return [(radius * math.cos(2 * math.pi * i / sides), radius * math.sin(2 * math.pi * i / sides), z) for i in range(sides)]
    below, above, faces = ring(low, 0), ring(high, HEIGHT), []
    for i in range(sides):
        j = (i + 1) % sides
        faces += [(below[i], below[j], above[j]), (below[i], above[j], above[i]), ((0, 0, 0), below[j], below[i]), ((0, 0, HEIGHT), above[i], above[j])]
    text = "".join("facet normal 0 0 0\nouter loop\n" + "".join(f"vertex {x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in face) + "endloop\nendfacet\n"
                   for face in faces)
    return f"solid vase\n{text}endsolid vase\n"


def settings(**more):
    return [word for key, value in (SETTINGS | more).items() for word in ("--set", f"{key}={value}")]


def moves_of(gcode):
    """Returns (layer, start, end, e) of each G1; layers count from 0."""
    layer, x, y, z, moves = -1, 0.0, 0.0, 0.0, []
    for line in gcode.splitlines():
        if line.startswith(";LAYER_CHANGE"):
            layer += 1
        if not line.startswith("G1 "):
            continue
        words = {letter: float(value) for letter, value in re.findall(r"([XYZE])(-?\d*\.?\d+)", line.split(";")[0])}
        before, (x, y, z) = (x, y, z), (words.get("X", x), words.get("Y", y), words.get("Z", z))
        moves.append((layer, before, (x, y, z), words.get("E", 0)))
    return moves


def check_one_bead(gcode):
    moves = [move for move in moves_of(gcode) if BOTTOM <= move[0] < LAYERS]
    first = next(i for i, (_, before, to, pushed) in enumerate(moves) if pushed > 0 and before[:2] != to[:2])
    last = max(i for i, (_, before, to, pushed) in enumerate(moves) if pushed > 0 and before[:2] != to[:2])
    spiral = moves[first:last + 1]
    ways = [math.dist(before[:2], to[:2]) for _, before, to, pushed in spiral if pushed == 0]
    assert len(spiral) > 100 and max(ways, default=0) < 0.002, f"a travel of {max(ways)} mm within the spiral"
    assert all(pushed >= 0 for _, _, _, pushed in spiral), "it pulls back"
    heights = [to[2] for _, _, to, _ in spiral]
    assert heights == sorted(heights), "it goes down"
    steps = [to[2] - before[2] for _, before, to, _ in spiral]
    assert max(steps) < 0.02, f"a step of {max(steps)} mm"
    assert abs(heights[0] - 0.8) < 0.01 and abs(heights[-1] - HEIGHT) < 1e-9, heights[::len(heights) - 1]
    return spiral


def check_plastic(spiral):
    """Checks that the plastic equals one loop per layer, half a bead inside the cone."""
    section = (0.5 - 0.2) * 0.2 + math.pi / 4 * 0.2 ** 2
    loops = sum(2 * math.pi * (10 + 3 * (layer + 0.5) / LAYERS - 0.25) for layer in range(BOTTOM, LAYERS))
    pushed = sum(move[3] for move in spiral) * math.pi / 4 * 1.75 ** 2
    assert abs(pushed / (loops * section) - 1) < 0.005, (pushed, loops * section)


def check_radius(spiral, centre):
    """Checks that the radius grows as evenly as the height: there is no seam."""
    for _, _, (x, y, z), _ in spiral:
        if z < 1.1 or z > HEIGHT - 0.3:
            continue
        wanted = 10 + 3 * (z - 0.1) / HEIGHT - 0.25
        got = math.hypot(x - centre[0], y - centre[1])
        assert abs(got - wanted) < 0.03, (z, got, wanted)


def check_copies(program, model, folder):
    refused = run(program, "slice", model, "--copies", f"{model}=2", "-o", folder / "no.gcode", *settings())
    assert refused.returncode == BAD_SETTING and "complete_objects = 1" in refused.stderr, (refused.returncode, refused.stderr)
    must(program, "slice", model, "--copies", f"{model}=2", "-o", folder / "two.gcode", "-q", *settings(complete_objects="1", extruder_clearance_radius="5"))
    moves = moves_of((folder / "two.gcode").read_text())
    rises = [i for i in range(1, len(moves)) if moves[i][1][2] - moves[i][2][2] > 5 and moves[i][0] > 0]
    assert rises, "the second copy begins at the bed"


def check_told(program, model, folder):
    told = run(program, "slice", model, "-o", folder / "told.gcode", *settings(skirts="1", skirt_height="6"))
    assert told.returncode == 0 and "2 of the 46 layers above the bottom are not a single loop" in told.stderr, told.stderr


def check_farm(model, folder, wanted):
    from local_farm import running_farm
    with running_farm(workers=2) as farm:
        done = farm.client("submit", model, "-o", folder / "farm.gcode", "--center", "100,100", *settings())
        assert done.returncode == 0, done.stderr
    assert (folder / "farm.gcode").read_text() == wanted, "the farm's bytes differ"


def main():
    program = os.path.abspath(sys.argv[1])
    os.environ["SLICEFARM_BIN"] = os.path.dirname(program)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        model = folder / "vase.stl"
        model.write_text(cone())
        output = folder / "vase.gcode"
        for threads in ("1", "4"):
            must(program, "slice", model, "-o", output, "-q", "--threads", threads, "--center", "100,100", *settings())
            gcode = output.read_text()
            if threads == "1":
                first = gcode
        assert gcode == first, "bytes depend on threads"
        spiral = check_one_bead(gcode)
        check_plastic(spiral)
        check_radius(spiral, (100, 100))
        check_copies(program, model, folder)
        check_told(program, model, folder)
        check_farm(model, folder, first)


if __name__ == "__main__":
    main()
