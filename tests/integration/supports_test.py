#!/usr/bin/env python3
"""Tests supports and layer heights, from file to G-code. Overhangs are supported up to the contact gap, painted
supports are below the paint, and no thick bead is printed directly over a support. Copies that overlap are refused.
Manually drawn and adaptive layer heights are kept. The bytes are the same for any number of threads, and from a farm
of real processes.

usage: supports_test.py SLICEFARM MODELS
"""
import collections
import math
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from project_test import cube, item, mesh_xml, model_xml, must, painted, run, write

BED = "0x0,256x0,256x256,0x256"
SETTINGS = {"bed_shape": BED, "layer_height": "0.25", "first_layer_height": "0.25", "support_material": "1", "support_material_contact_distance": "0.25",
            "nozzle_diameter": "0.4", "thick_bridges": "1", "gcode_label_objects": "octoprint"}

BAD_MESH = 4  # exit code
CLOSE = ((50, 60, False), (69, 65, False))

Bead = collections.namedtuple("Bead", "feature label z height a b")


def box(x0, y0, z0, x1, y1, z1):
    corners, faces = cube(0, 0, 0, 1)
    return [(x0 + x * (x1 - x0), y0 + y * (y1 - y0), z0 + z * (z1 - z0)) for x, y, z in corners], faces


def table(state=None, attribute="", more=None, places=((50, 60, False), (120, 60, True))):
    """Returns a project with a slab of 20 mm x 20 mm on a post at its middle. Its underside is 10 mm above the bed. The
    slab has two copies, the second one rotated.
    """
    mesh = mesh_xml(box(8, 8, 0, 12, 12, 11), box(0, 0, 10, 20, 20, 13))
    if state is not None:
        mesh = painted(mesh, state, attribute)
    return {"3D/3dmodel.model": model_xml(f'<object id="1" type="model">{mesh}</object>', "".join(item(1, *place) for place in places), "PrusaSlicer-2.9.2"),
            "Metadata/Slic3r_PE.config": "".join(f"; {key} = {value}\n" for key, value in (SETTINGS | (more or {})).items())}


def beads_of(gcode):
    """Returns all beads of a program with relative or absolute E."""
    feature = label = ""
    x = y = z = e = height = 0.0
    relative, beads = False, []
    for line in gcode.splitlines():
        if line.startswith(";TYPE:"):
            feature = line[6:]
        elif line.startswith(";HEIGHT:"):
            height = float(line[8:])
        elif line.startswith("; printing object "):
            label = line[18:]
        elif line.startswith(("M82", "M83")):
            relative = line.startswith("M83")
        if not line.startswith(("G1 ", "G92 ")):
            continue
        words = {letter: float(value) for letter, value in re.findall(r"([XYZE])(-?\d*\.?\d+)", line.split(";")[0])}
        pushed = words.get("E", 0) if relative else words.get("E", e) - e
        e = words.get("E", e)
        before, (x, y, z) = (x, y), (words.get("X", x), words.get("Y", y), words.get("Z", z))
        if line.startswith("G1 ") and pushed > 0 and before != (x, y):
            beads.append(Bead(feature, label, z, height, before, (x, y)))
    return beads


def sliced(program, folder, project, *arguments):
    must(program, "slice", project, "-o", folder / "out.gcode", "-q", *arguments)
    return beads_of((folder / "out.gcode").read_text())


def supports(beads):
    return [bead for bead in beads if bead.feature.startswith("Support material")]


def on_object(bead):
    """Returns the ends of a bead in the coordinates of the object itself, for either copy."""
    def place(p):
        return (p[0] - 50, p[1] - 60) if p[0] < 80 else (p[1] - 60, 120 - p[0])
    return place(bead.a), place(bead.b)


def check_automatic(program, folder):
    project = write(folder / "table.3mf", table())
    for style in ("grid", "snug", "organic"):
        beads = sliced(program, folder, project, "--set", f"support_material_style={style}")
        held = supports(beads)
        assert abs(max(bead.z for bead in held) - 9.75) < 1e-6, f"{style}: the top lies at the gap, {max(bead.z for bead in held)}"
        tops = [place for bead in held if abs(bead.z - 9.75) < 1e-6 for place in on_object(bead)]
        for corner in ((0, 0), (20, 0), (0, 20), (20, 20)):
            assert min(abs(x - corner[0]) + abs(y - corner[1]) for x, y in tops) < 1.5, f"{style}: nothing below the corner {corner}"
        for bead in held:
            for x, y in on_object(bead):
                assert not (7.9 < x < 12.1 and 7.9 < y < 12.1), f"{style}: {bead} is in the post"
        thick = [bead for bead in beads if bead.height > 0.25 + 1e-6]
        assert not thick, f"{style}: threads right over a support, {thick[:3]}"
        counts = collections.Counter(bead.label for bead in held)
        assert len(counts) == 2 and len(set(counts.values())) == 1, f"{style}: each copy has its own, all alike, {counts}"


def check_another_object_below(program, folder):
    """Checks a block of 5 mm below the slab: supports avoid the block, and no support starts on it."""
    mesh, block = mesh_xml(box(8, 8, 0, 12, 12, 11), box(0, 0, 10, 20, 20, 13)), mesh_xml(box(0, 0, 0, 5, 5, 5))
    files = table()
    files["3D/3dmodel.model"] = model_xml(f'<object id="1" type="model">{mesh}</object><object id="2" type="model">{block}</object>',
                                          item(1, 50, 60) + item(2, 51, 61), "PrusaSlicer-2.9.2")
    project = write(folder / "two.3mf", files)
    for style in ("grid", "snug", "organic"):
        held = supports(sliced(program, folder, project, "--set", f"support_material_style={style}"))
        assert held, style
        for bead in held:
            for x, y in (bead.a, bead.b):
                assert not (bead.z < 5.2 and 50.9 < x < 56.1 and 60.9 < y < 66.1), f"{style}: {bead} is in the block"
        corner = [bead for bead in held if bead.z > 9.7 and 51.2 < bead.a[0] < 55.8 and 61.2 < bead.a[1] < 65.8]
        assert style == "organic" or not corner, f"{style}: a column stands on the block"


def check_copies(program, folder):
    """Checks that each of ten copies has the same supports, under its own label."""
    places = [(30 + 40 * (i % 5), 60 + 40 * (i // 5), False) for i in range(10)]
    held = supports(sliced(program, folder, write(folder / "ten.3mf", table(places=places))))
    by_label = collections.defaultdict(list)
    for bead in held:
        by_label[bead.label].append(bead)
    assert len(by_label) == 10
    shapes = {tuple(sorted((round(bead.a[0] - min(b.a[0] for b in beads), 3), round(bead.a[1] - min(b.a[1] for b in beads), 3), bead.z)
                           for bead in beads)) for beads in by_label.values()}
    assert len(shapes) == 1, "all alike"


def check_conflicts(program, folder):
    """Checks that copies whose supports or parts overlap are refused with the names of both copies. Copies that only
    touch are not refused.
    """
    def refusal(places, *arguments):
        done = run(program, "slice", write(folder / "plate.3mf", table(places=places)), "-o", folder / "out.gcode", "-q", *arguments)
        assert done.returncode in (0, BAD_MESH), done.stderr
        return done.stderr if done.returncode else ""

    for style in ("grid", "snug", "organic"):
        assert not refusal(((50, 60, False), (70, 60, False)), "--set", f"support_material_style={style}", "--set", "brim_width=3")
    met = refusal(CLOSE)
    assert "object 1 (copy 1)" in met and "object 1 (copy 2)" in met and "share room" in met, met
    assert "share room" in refusal(CLOSE, "--set", "support_material=0")
    assert not refusal(CLOSE, "--set", "objects_may_overlap=1")


def check_bridges_without_supports_are_threads(program, folder):
    beads = sliced(program, folder, write(folder / "table.3mf", table()), "--set", "support_material=0")
    assert not supports(beads)
    assert any(bead.height > 0.35 for bead in beads), "thick_bridges makes threads where nothing carries them"


def check_painted(program, folder):
    """Checks painted supports. The painted underside is horizontal, so no slicing plane cuts its paint."""
    def left(enforce):
        return lambda x, y, z: (1 if enforce else 2) if abs(z - 10) < 1e-6 and x < 7 else 0

    for attribute in ("slic3rpe:custom_supports", "paint_supports"):
        project = write(folder / "enforced.3mf", table(left(True), attribute, {"support_material_auto": "0", "support_material_style": "snug"}))
        assert '"support_enforcer"' in must(program, "inspect", project)
        held = supports(sliced(program, folder, project))
        xs = [x for bead in held for x, _ in on_object(bead)]
        assert held and min(xs) < 1 and max(x for bead in held if bead.z > 9.7 for x, _ in on_object(bead)) < 8, (min(xs), max(xs))
        assert len({bead.label for bead in held}) == 2
        blocked = write(folder / "blocked.3mf", table(left(False), attribute, {"support_material_style": "snug"}))
        tops = [x for bead in supports(sliced(program, folder, blocked)) if bead.z > 9.7 for x, _ in on_object(bead)]
        assert tops and min(tops) > 6.3 and max(tops) > 19, (min(tops), max(tops))
    assert not supports(sliced(program, folder, write(folder / "none.3mf", table(more={"support_material_auto": "0"}))))


def check_heights_drawn_by_hand(program, folder):
    files = table(more={"support_material": "0"})
    files["Metadata/Slic3r_PE_layer_heights_profile.txt"] = "object_id=1|0.000000;0.250000;4.000000;0.250000;6.000000;0.100000;13.000000;0.100000\n"
    done = sliced(program, folder, write(folder / "drawn.3mf", files))
    heights = sorted({bead.z for bead in done})
    steps = [round(b - a, 4) for a, b in zip(heights, heights[1:])]
    assert all(abs(step - 0.25) < 1e-3 for step, z in zip(steps, heights) if z < 3.9), steps
    assert all(abs(step - 0.1) < 1e-3 for step, z in zip(steps, heights) if z > 6), steps
    assert any(0.11 < step < 0.24 for step in steps), "in between in proportion"
    held = supports(sliced(program, folder, folder / "drawn.3mf", "--set", "support_material=1"))
    assert held and abs(max(bead.z for bead in held) - (min(z for z in heights if z > 10) - 0.1 - 0.25)) < 0.11, "supports follow"


def check_adaptive(program, folder, models):
    def heights(*arguments):
        return sorted({bead.z for bead in sliced(program, folder, models / "spot.stl", "--set", "first_layer_height=0.2", *arguments)
                       if bead.feature == "External perimeter"})
    fitted = heights("--set", "adaptive_layer_height=1")
    steps = {round(b - a, 3) for a, b in zip(fitted, fitted[1:])}
    assert min(steps) >= 0.069 and max(steps) <= 0.301 and len(steps) > 5, steps
    coarse = heights("--set", "adaptive_layer_height=1", "--set", "adaptive_layer_cusp=0.2")
    assert len(coarse) < len(fitted)
    project = write(folder / "table.3mf", table(more={"adaptive_layer_height": "1", "support_material": "0"}))
    tops = {bead.z for bead in sliced(program, folder, project)}
    assert 10 in tops and 13 in tops, "level faces are met exactly"
    held = sliced(program, folder, models / "spot.stl", "--set", "adaptive_layer_height=1", "--set", "support_material=1", "--set",
                  "support_material_style=organic")
    assert supports(held), "branches beside layers of many heights"


def check_first_layer(program, folder):
    """Checks that an overhang too low for a first layer of supports does not lower the part's first layer. Checks that
    skirts skip layers that have supports only.
    """
    mesh = mesh_xml(box(0, 0, 0, 10, 10, 5), box(10, 0, 0.4, 14, 10, 5), box(-8, 0, 2.05, 0, 10, 5))
    settings = SETTINGS | {"first_layer_height": "0.3", "layer_height": "0.1", "support_material_contact_distance": "0.15", "skirts": "1", "skirt_height": "5",
                           "skirt_distance": "3", "brim_type": "no_brim"}
    files = {"3D/3dmodel.model": model_xml(f'<object id="1" type="model">{mesh}</object>', item(1, 50, 60, False), "PrusaSlicer-2.9.2"),
             "Metadata/Slic3r_PE.config": "".join(f"; {key} = {value}\n" for key, value in settings.items())}
    for style in ("grid", "organic"):
        beads = sliced(program, folder, write(folder / "low.3mf", files), "--set", f"support_material_style={style}")
        assert min(bead.z for bead in beads) == 0.3, min(bead.z for bead in beads)
        assert any(bead.feature == "Support material" for bead in beads), style
        skirt = sorted({(bead.z, bead.height) for bead in beads if bead.feature == "Skirt/Brim"})
        assert skirt == [(0.3, 0.3), (0.4, 0.1), (0.5, 0.1), (0.6, 0.1), (0.7, 0.1)], skirt


def points_on(bead, step=0.25):
    """Returns points along a bead, at most `step` apart, with the length that each of them represents."""
    (ax, ay), (bx, by) = bead.a, bead.b
    length = math.hypot(bx - ax, by - ay)
    count = int(length / step) + 1
    return [((ax + (bx - ax) * (i + 0.5) / count, ay + (by - ay) * (i + 0.5) / count), length / count) for i in range(count)]


def lying_on_nothing(beads, reach=1.0, bridged=4.0):
    """Returns the lengths, in mm by height, of unsupported pieces of support beads. These pieces are farther than
    `reach` from all beads of the layer below, and too long (`bridged`) to bridge between two supported points.
    """
    heights = sorted({bead.z for bead in beads})
    floating = collections.Counter()
    for below, here in zip(heights, heights[1:]):
        cells = collections.defaultdict(list)
        for bead in beads:
            if bead.z == below:
                for (x, y), _ in points_on(bead):
                    cells[int(x // reach), int(y // reach)].append((x, y))

        def lies(x, y):
            column, row = int(x // reach), int(y // reach)
            return any(math.dist((x, y), p) <= reach for i in (-1, 0, 1) for k in (-1, 0, 1) for p in cells.get((column + i, row + k), ()))

        run, last = 0.0, None
        for bead in supports([bead for bead in beads if bead.z == here]) + [None]:
            if bead is None or bead.a != last:
                floating[here] += run if run > bridged - 2 * reach else 0
                run = 0.0
            if bead is None:
                break
            last = bead.b
            for (x, y), length in points_on(bead):
                if not lies(x, y):
                    run += length
                elif run:
                    floating[here] += run if run > bridged - 2 * reach else 0
                    run = 0.0
    return {z: round(length, 2) for z, length in floating.items() if length > 0}


def check_organic_beads_lie_on_something(program, folder):
    """Checks that all support beads rest on a bead below. The part is a wide plate low over the bed, with many branches
    whose feet overlap.
    """
    mesh = mesh_xml(box(24, 14, 0, 30, 20, 8), box(0, 0, 6, 54, 34, 8))
    settings = SETTINGS | {"layer_height": "0.2", "first_layer_height": "0.2", "support_material_contact_distance": "0.2"}
    files = {"3D/3dmodel.model": model_xml(f'<object id="1" type="model">{mesh}</object>', item(1, 50, 60, False), "PrusaSlicer-2.9.2"),
             "Metadata/Slic3r_PE.config": "".join(f"; {key} = {value}\n" for key, value in settings.items())}
    for more in ({}, {"support_tree_branch_diameter": "5"}, {"support_tree_branch_diameter_angle": "15"}):
        arguments = [word for key, value in more.items() for word in ("--set", f"{key}={value}")]
        beads = sliced(program, folder, write(folder / "plate.3mf", files), "--set", "support_material_style=organic", *arguments)
        low = [bead for bead in supports(beads) if bead.z < 5]
        assert len(low) > 1000, len(low)
        floating = lying_on_nothing([bead for bead in beads if bead.z < 5])
        assert not floating, f"{more}: mm of support on nothing, by height: {floating}"


def check_same_bytes(program, folder, models):
    os.environ["SLICEFARM_BIN"] = str(pathlib.Path(program).resolve().parent)
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
    from local_farm import running_farm

    def left(x, y, z):
        return 1 if abs(z - 10) < 1e-6 and x < 7 else 0

    painted_table = write(folder / "enforced.3mf", table(left, "paint_supports", {"support_material_auto": "0"}))
    everything = ["--set", "support_material=1", "--set", "adaptive_layer_height=1", "--set", "raft_layers=2", "--set", "brim_type=outer_only",
                  "--set", "brim_width=3", "--set", "first_layer_height=0.2"]
    jobs = {"painted": [painted_table], "organic": [models / "spot.stl", *everything, "--set", "support_material_style=organic"],
            "grid": [models / "spot.stl", *everything, "--set", "support_material_style=grid"]}
    want = {}
    for name, job in jobs.items():
        must(program, "slice", *job, "-o", folder / f"{name}.gcode", "-q", "--threads", 1)
        want[name] = (folder / f"{name}.gcode").read_bytes()
        must(program, "slice", *job, "-o", folder / "again.gcode", "-q", "--threads", 4)
        assert (folder / "again.gcode").read_bytes() == want[name], f"{name}: another number of threads"
    for workers in (1, 2, 8):
        with running_farm(workers=workers) as farm:
            for name, job in jobs.items():
                done = farm.client("submit", *job, "-o", folder / "there.gcode")
                assert done.returncode == 0, done.stderr
                assert (folder / "there.gcode").read_bytes() == want[name], f"{name}: a farm of {workers} makes other bytes"
            check_conflict_there(farm, folder)


def check_conflict_there(farm, folder):
    """Checks that a job with overlapping copies ends on the farm before any range is sent."""
    def sent():
        return sum(coordinator.metric("slicefarm_ranges_total") or 0 for coordinator in farm.coordinators)

    before = sent()
    done = farm.client("submit", write(folder / "close.3mf", table(places=CLOSE)), "-o", folder / "there.gcode")
    assert done.returncode == BAD_MESH and "share room" in done.stderr, done.stderr
    assert sent() == before, "ranges of a job that is refused"


def main(program, models):
    with tempfile.TemporaryDirectory() as name:
        folder, models = pathlib.Path(name), pathlib.Path(models)
        for check in (check_automatic, check_another_object_below, check_copies, check_conflicts, check_bridges_without_supports_are_threads, check_painted, check_heights_drawn_by_hand, check_first_layer,
                      check_organic_beads_lie_on_something):
            check(program, folder)
            print(f"{check.__name__}: ok", flush=True)
        for check in (check_adaptive, check_same_bytes):
            check(program, folder, models)
            print(f"{check.__name__}: ok", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
