#!/usr/bin/env python3
"""Tests copies that are printed one after the other (complete_objects), by replaying their G-code:

- the head is a cylinder of extruder_clearance_radius around the nozzle, below a gantry at extruder_clearance_height. It
  never touches a printed copy, and the nozzle never moves below the printed top of the current copy;
- each copy has its own layers from the bed up, and the layers are counted over all copies;
- a plate without a possible order is refused with the names of two copies;
- the bytes do not depend on the number of threads.

usage: sequence_test.py SLICEFARM MODELS
"""
import collections
import math
import pathlib
import re
import subprocess
import sys
import tempfile

COMMON = ["--set", "complete_objects=1", "--set", "gcode_label_objects=octoprint", "--set", "first_layer_height=0.3",
          "--set", "fill_density=3%", "--set", "perimeters=1",
          "--set", "bed_shape=0x0,250x0,250x210,0x210", "--set", "layer_gcode=;NUMBER {layer_num} {max_layer_z} {total_layer_count}"]
TOLERANCE_MM = 0.003

# Name, models and settings, and the clearances in the settings.
Plate = collections.namedtuple("Plate", "name arguments radius height", defaults=(20, 20))
PLATES = [
    Plate("copies", ["busted.stl", "--copies", "busted.stl=4"]),
    Plate("a tall one among flat ones", ["spot.stl", "busted.stl", "textbox.stl", "--copies", "busted.stl=2"]),
    Plate("a wide head, lifts", ["textbox.stl", "busted.stl", "--copies", "busted.stl=3", "--set", "extruder_clearance_radius=45",
                                 "--set", "retract_lift=0.6"], 45),
    Plate("layer heights of their own", ["busted.stl", "textbox.stl", "--object-set", "busted.stl:layer_height=0.15",
                                         "--object-set", "textbox.stl:layer_height=0.25"]),
    Plate("a low gantry", ["textbox.stl", "busted.stl", "--set", "extruder_clearance_height=9.8",
                           "--set", "between_objects_gcode=;BETWEEN {current_object_idx}\\nG1 Z0.1"], 20, 9.8),
]


def run(program, folder, arguments):
    output = pathlib.Path(folder, "out.gcode")
    done = subprocess.run([program, "slice", *COMMON, *arguments, "-o", output, "-q"], capture_output=True, text=True)
    return done, output


def slice_plate(program, folder, models, arguments, threads=2):
    paths = [str(models / a) if a.endswith(".stl") else a for a in arguments]
    done, output = run(program, folder, [*paths, "--threads", str(threads)])
    assert done.returncode == 0, done.stderr
    return output.read_text()


def hull(points):
    points = sorted(set(points))

    def half(points):
        chain = []
        for p in points:
            while len(chain) > 1 and cross(chain[-2], chain[-1], p) <= 0:
                chain.pop()
            chain.append(p)
        return chain[:-1]
    return half(points) + half(points[::-1])


def cross(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def to_segment(p, a, b):
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = dx * dx + dy * dy
    t = 0 if length == 0 else max(0, min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length))
    return math.hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy)


def distance(a, b, polygon):
    """Returns the distance of the segment from the convex polygon; 0 if they meet."""
    nearest = math.inf
    for c, d in zip(polygon, polygon[1:] + polygon[:1]):
        if cross(a, b, c) * cross(a, b, d) < 0 and cross(c, d, a) * cross(c, d, b) < 0:
            return 0
        nearest = min(nearest, to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b))
    inside = all(cross(c, d, a) >= 0 for c, d in zip(polygon, polygon[1:] + polygon[:1]))
    return 0 if inside else nearest


def boxes_gap(a, b):
    """Returns the gap in x or in y between the boxes of two sets of points. It is a lower bound of the points'
    distance.
    """
    return max(max(min(p[i] for p in a) - max(p[i] for p in b), min(p[i] for p in b) - max(p[i] for p in a)) for i in (0, 1))


class Replay:
    """Follows a program and detects collisions of the head."""

    def __init__(self, radius, height):
        self.radius, self.height = radius, height
        self.at, self.z = (0, 0), 0
        self.label, self.last = None, None
        self.points = collections.defaultdict(set)   # end points of each copy's beads
        self.tops = collections.defaultdict(float)
        self.layers = collections.defaultdict(list)  # layer heights of each copy
        self.finished = []                           # (label, hull) of each finished copy
        self.heads_way = 0

    def enter(self, label):
        if label != self.last and self.last is not None:
            assert label not in dict(self.finished), f"{label} is printed in two pieces"
            self.finished.append((self.last, hull(self.points[self.last])))
        self.label = self.last = label

    def move(self, words):
        to = (float(words.get("X", self.at[0])), float(words.get("Y", self.at[1])))
        z = float(words.get("Z", self.z))
        assert to == self.at or z == self.z, f"moves up and along at once: {words}"
        self.check(self.at, to, min(z, self.z))
        if self.label and "E" in words and to != self.at:
            self.points[self.label] |= {self.at, to}
            self.tops[self.label] = z
            if z not in self.layers[self.label][-1:]:
                self.layers[self.label].append(z)
        self.at, self.z = to, z

    def check(self, a, b, low):
        for label, outline in self.finished:
            top = self.tops[label]
            assert low + self.height >= top - 1e-6, f"the gantry at {low} + {self.height} meets {label}, {top} high"
            if top > low + 1e-6 and boxes_gap((a, b), outline) < self.radius:
                gap = distance(a, b, outline)
                assert gap >= self.radius - TOLERANCE_MM, f"the head at {low} is {gap:.3f} mm from {label}, {top} high"
        if self.last is not None and a != b:
            assert low >= self.tops[self.last] - 1e-6, f"moves at {low} over {self.last}, {self.tops[self.last]} high"
        self.heads_way += math.dist(a, b)


def replay(gcode, radius, height):
    """Replays a program from the first layer to the end G-code. The end G-code is the user's, and may home the axes."""
    state = Replay(radius, height)
    body = gcode[gcode.index(";LAYER_CHANGE"):gcode.index("M107\nM104 S0")]
    for line in body.splitlines():
        if line.startswith("; printing object "):
            state.enter(line.removeprefix("; printing object "))
        elif line.startswith("; stop printing object "):
            state.label = None
        elif line.startswith("G1 "):
            state.move(dict(re.findall(r"([XYZEF])(-?\d*\.?\d+)", line)))
    return state


def check_plate(program, folder, models, plate):
    gcode = slice_plate(program, folder, models, plate.arguments)
    own = [line for line in plate.arguments if "between_objects_gcode" in line]
    if own:  # removes the user's own move down before the replay
        between = re.findall(r";BETWEEN (\d+)\nG1 Z0\.1\nG21\nG90\nM83\n(G1 Z\S+) F\d+\nG1 X", gcode)
        assert [int(number) for number, _ in between] == list(range(1, len(between) + 1)) and between, between
        gcode = re.sub(r";BETWEEN \d+\nG1 Z0\.1\n", "", gcode)
    state = replay(gcode, plate.radius, plate.height)
    copies = list(state.layers)
    assert len(copies) == len(state.finished) + 1, copies
    for label, heights in state.layers.items():
        assert heights[0] == 0.3 and heights == sorted(heights), f"{label}: {heights[:3]}"
    assert gcode.count(";LAYER_CHANGE") == sum(map(len, state.layers.values()))
    numbers = [(int(n), float(top), int(total)) for n, top, total in re.findall(r";NUMBER (\d+) (\S+) (\d+)", gcode)]
    assert [n for n, _, _ in numbers] == list(range(len(numbers))), "layers are not counted over all copies"
    assert {total for _, _, total in numbers} == {len(numbers)}, {total for _, _, total in numbers}
    tops = [top for _, top, _ in numbers]
    assert tops == sorted(tops) and abs(tops[-1] - max(state.tops.values())) < 1e-6, tops[-1]
    if "spot.stl" not in plate.arguments:
        alone = slice_plate(program, folder, models, plate.arguments, 1)
        assert re.sub(r";BETWEEN \d+\nG1 Z0\.1\n", "", alone) == gcode, "other bytes with one thread"
    print(f"{plate.name}: {len(copies)} copies, {len(numbers)} layers, {state.heads_way:.0f} mm without a collision")


def check_refusals(program, folder, models):
    """Checks that two tall copies, and two copies that are too close to each other, are refused."""
    for arguments, names in [(["spot.stl", "spot.stl"], ["spot.stl"]),
                             (["spot.stl", "--copies", "spot.stl=2"], ["spot.stl (copy 1)", "spot.stl (copy 2)"]),
                             (["busted.stl", "textbox.stl", "--center", "100,100"], ["busted.stl", "textbox.stl"])]:
        done, _ = run(program, folder, [str(models / a) if a.endswith(".stl") else a for a in arguments])
        assert done.returncode != 0, arguments
        assert all(name in done.stderr for name in names), done.stderr
        assert "one after the other" in done.stderr, done.stderr


def check_the_replay(program, folder, models):
    """Checks that the replay detects that the same copies printed layer by layer are no sequence."""
    gcode = slice_plate(program, folder, models, ["busted.stl", "--copies", "busted.stl=2", "--set", "complete_objects=0"])
    for radius, height in [(20, 20), (1, 1)]:
        try:
            replay(gcode, radius, height)
        except AssertionError:
            continue
        raise AssertionError("the replay of copies that are printed layer by layer finds nothing")


def main():
    program, models = sys.argv[1], pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        check_the_replay(program, folder, models)
        check_refusals(program, folder, models)
        for plate in PLATES:
            check_plate(program, folder, models, plate)


if __name__ == "__main__":
    main()
