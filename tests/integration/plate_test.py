#!/usr/bin/env python3
"""What a plate promises, replayed from its G-code:

- the beads of an object are those of the object alone, moved, whatever else is printed;
- copies of an object are alike;
- objects with layer heights of their own are printed at these, and the nozzle never moves below what is printed.

usage: plate_test.py SLICEFARM MODELS
"""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

# Cooling slows whole layers down, and so would make an object's speeds depend on the others.
COMMON = ["--set", "gcode_label_objects=octoprint", "--set", "cooling=0", "--set", "bed_shape=0x0,250x0,250x210,0x210", "-q"]
FIRST_UM = 200

Move = collections.namedtuple("Move", "label z_um from_um to_um e f")


def slice_plate(program, folder, arguments):
    output = pathlib.Path(folder, "out.gcode")
    subprocess.run([program, "slice", *arguments, "-o", output, *COMMON], check=True, stderr=subprocess.DEVNULL)
    return output.read_text()


def micrometres(text):
    return round(float(text) * 1000)


def moves(gcode):
    """All moves along the bed; label: the copy's, between its labels; e: None for travels."""
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
    """Of each label: its beads from the least corner, sorted, so that neither place nor order counts."""
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
    """Each model alone at the edge of the bed, then among copies of itself and another object with its own settings."""
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
    """What the check above would not see if it compared nothing."""
    model = str(models / "busted.stl")
    thin, = beads_by_copy(slice_plate(program, folder, [model, "--object-set", "busted.stl:perimeters=1"])).values()
    usual, = beads_by_copy(slice_plate(program, folder, [model])).values()
    assert thin != usual


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
        check_layer_heights(program, folder, models)


if __name__ == "__main__":
    main()
