#!/usr/bin/env python3
"""Tests the guarantees for a plate by replaying its G-code:

- the beads of an object equal the beads of the object alone, moved, whichever other objects are printed;
- copies of an object are identical;
- a copy that the firmware leaves out (Klipper's exclude_object) does not change the other copies;
- objects with their own layer heights are printed at these heights, and the nozzle never moves below the printed top.

usage: plate_test.py SLICEFARM MODELS
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

# Cooling is off, because it slows whole layers down. An object's speeds would then depend on other objects.
COMMON = ["--set", "cooling=0", "--set", "bed_shape=0x0,250x0,250x210,0x210", "-q"]
LABELLED = ["--set", "gcode_label_objects=octoprint"]
FIRST_UM = 200

Move = collections.namedtuple("Move", "label z_um from_um to_um e f")


def slice_plate(program, folder, arguments):
    """Slices a plate and returns the G-code; `arguments` override LABELLED."""
    output = pathlib.Path(folder, "out.gcode")
    subprocess.run([program, "slice", "-o", output, *COMMON, *LABELLED, *arguments], check=True, stderr=subprocess.DEVNULL)
    return output.read_text()


def micrometres(text):
    return round(float(text) * 1000)


def moves(gcode):
    """Yields all moves in XY; label: the copy whose labels enclose the move; e: None for travels."""
    label, at, z, f = None, (0, 0), 0, None
    for line in gcode.splitlines():
        if line.startswith("; printing object "):
            label = line.removeprefix("; printing object ")
        elif line.startswith("; stop printing object "):
            label = None
        if not line.startswith("G1 "):
            continue
        words = dict(re.findall(r"([XYZEF])(-?\d*\.?\d+)", line))
        z = micrometres(words["Z"]) if "Z" in words else z
        f = words.get("F", f)
        if "X" in words or "Y" in words:
            to = (micrometres(words["X"]) if "X" in words else at[0], micrometres(words["Y"]) if "Y" in words else at[1])
            yield Move(label, z, at, to, words.get("E"), f)
            at = to


def beads_by_copy(gcode):
    """Returns the beads of each label, relative to its least corner and sorted, so that position and order do not
    matter.
    """
    beads = collections.defaultdict(list)
    for move in moves(gcode):
        if move.label and move.e:
            beads[move.label].append(move)
    result = {}
    for label, all_moves in beads.items():
        x = min(min(m.from_um[0], m.to_um[0]) for m in all_moves)
        y = min(min(m.from_um[1], m.to_um[1]) for m in all_moves)
        result[label] = sorted((m.z_um, m.from_um[0] - x, m.from_um[1] - y, m.to_um[0] - x, m.to_um[1] - y, m.e, m.f)
                               for m in all_moves)
    return result


def check_objects_are_independent(program, folder, models):
    """Checks that each model has the same beads alone at the edge of the bed and among copies of itself and another
    object with its own settings.
    """
    for name, other in [("busted", "textbox"), ("textbox", "busted"), ("thin_walls", "spot")]:
        model, second = str(models / f"{name}.stl"), str(models / f"{other}.stl")
        alone = beads_by_copy(slice_plate(program, folder, [model, "--center", "101.3,57.7"]))
        plate = beads_by_copy(slice_plate(program, folder, [
            model, second, "--copies", f"{name}.stl=2", "--object-set", f"{other}.stl:fill_density=61%",
            "--object-set", f"{other}.stl:perimeters=4"]))
        want, = alone.values()
        copies = [beads for label, beads in plate.items() if label.startswith(name)]
        assert len(want) > 1000, f"{name}: only {len(want)} beads"
        assert len(copies) == 2 and len(plate) == 3, list(plate)
        for beads in copies:
            assert beads == want, f"{name}: {len(set(beads) ^ set(want))} beads are not those of the object alone"
        print(f"{name}: {len(want)} beads, the same alone and on a plate")


def check_settings_are_seen(program, folder, models):
    """Checks that beads_by_copy detects a changed setting. Otherwise the check above could pass without comparing
    anything.
    """
    model = str(models / "busted.stl")
    thin, = beads_by_copy(slice_plate(program, folder, [model, "--object-set", "busted.stl:perimeters=1"])).values()
    usual, = beads_by_copy(slice_plate(program, folder, [model])).values()
    assert thin != usual


LABEL = re.compile(r"EXCLUDE_OBJECT_(DEFINE|START|END) NAME=(\S+)")


def without(gcode, excluded):
    """Returns the names of the objects, and the program as a firmware executes it if an object is excluded: without the
    lines between its labels. Checks the labels by the rules of exclude_object: names are defined once before use and
    have valid characters, and labels occur in pairs.
    """
    known, inside, kept = set(), None, []
    for line in gcode.splitlines():
        label = LABEL.match(line)
        assert label or not line.startswith("EXCLUDE_OBJECT"), line
        if label and label[1] == "DEFINE":
            assert label[2] not in known and re.fullmatch(r"[\w().-]+", label[2]), line
            known.add(label[2])
        elif label and label[1] == "START":
            assert inside is None and label[2] in known, line
            inside = label[2]
        elif label:
            assert inside == label[2], line
            inside = None
            kept.append(line)
            continue
        if inside is None or inside != excluded:
            kept.append(line)
    assert inside is None
    return known, "\n".join(kept)


def replay(gcode):
    """Returns the beads of each label with all values that determine them: start, retracted filament, and the last
    commands for fans, accelerations and pressure advance.
    """
    beads, label, state = collections.defaultdict(list), None, {}
    at, z, f, held = (0, 0), 0, None, 0
    for line in gcode.splitlines():
        found = LABEL.match(line)
        if found and found[1] != "DEFINE":
            label = found[2] if found[1] == "START" else None
        command = line.split(" ")[0]
        if command in ("M106", "M107"):
            state["fan"] = line
        elif command in ("M204", "SET_VELOCITY_LIMIT", "M104", "M220", "M221", "G90", "G91", "M82", "M83"):
            state[command] = line
        if command != "G1":
            continue
        words = dict(re.findall(r"([XYZEF])(-?\d*\.?\d+)", line))
        z, f = words.get("Z", z), words.get("F", f)
        to = words.get("X", at[0]), words.get("Y", at[1])
        e = micrometres(words.get("E", 0)) / 1000
        if to != at and e > 0:
            assert label or held == 0, line
            beads[label].append((at, to, z, words["E"], f, held, tuple(sorted(state.items()))))
        else:
            held -= e
        at = to
    return beads


def check_exclusion(program, folder, models):
    gcode = slice_plate(program, folder, [
        str(models / "busted.stl"), str(models / "thin_walls.stl"), "--copies", "busted.stl=2", "--set",
        "gcode_flavor=klipper", "--set", "gcode_label_objects=firmware", "--set", "skirts=1", "--set",
        "perimeter_acceleration=900", "--set", "infill_acceleration=1500", "--set", "default_acceleration=1000"])
    names, whole = without(gcode, None)
    assert len(names) == 3, names
    want = replay(whole)
    assert names < want.keys() and len(want[None]) > 0, "a skirt, and beads of each copy"
    for excluded in sorted(names):
        got = replay(without(gcode, excluded)[1])
        assert excluded not in got
        for name in want.keys() - {excluded}:
            assert got[name] == want[name], f"without {excluded}, {name} is not what it was"
    print(f"exclude_object: each of {len(names)} copies can be left out")


def check_layer_heights(program, folder, models):
    heights = {"spot": 150, "textbox": 250}
    arguments = [str(models / f"{name}.stl") for name in heights]
    for name, height in heights.items():
        arguments += ["--object-set", f"{name}.stl:layer_height={height / 1000}"]
    seen = collections.defaultdict(set)
    top = 0
    for move in moves(slice_plate(program, folder, [*arguments, "--set", f"first_layer_height={FIRST_UM / 1000}"])):
        assert move.z_um >= top or top == 0, f"moves at {move.z_um} um over beads that reach {top} um"
        if move.label and move.e:
            seen[move.label.split(".")[0]].add(move.z_um)
            top = max(top, move.z_um)
    assert seen.keys() == heights.keys(), list(seen)
    for name, z in seen.items():
        want = {FIRST_UM + i * heights[name] for i in range(len(z))}
        assert z == want, f"{name}: layers at {sorted(z ^ want)[:6]}"
        print(f"{name}: {len(z)} layers of {heights[name]} um")


def main():
    program, models = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        check_objects_are_independent(program, folder, models)
        check_settings_are_seen(program, folder, models)
        check_exclusion(program, folder, models)
        check_layer_heights(program, folder, models)


if __name__ == "__main__":
    main()
