#!/usr/bin/env python3
"""Tests that every region setting has an effect in a region. Each setting of the table gets a value that differs from
the part's. It is set in a modifier that covers one end of the part, and in a range of heights. Then the beads there
must differ, or the report must name the setting.

usage: region_settings_test.py SLICEFARM
"""
import json
import math
import os
import pathlib
import re
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from project_test import cube, item, mesh_xml, model_xml, must, run, write

JOB = {"bed_shape": "0x0,256x0,256x256,0x256", "layer_height": "0.3", "first_layer_height": "0.3", "nozzle_diameter": "0.4", "fill_density": "20%",
       "perimeters": "3", "fill_pattern": "rectilinear", "gcode_resolution": "0.05", "thumbnails": "", "perimeter_generator": "arachne"}
SPEEDS = {"enable_dynamic_overhang_speeds": "1", "overhang_speed_0": "11", "overhang_speed_1": "12", "overhang_speed_2": "13", "overhang_speed_3": "14"}
# Settings that a job needs for a setting to have an effect, by the beginning of its name.
CONTEXTS = {
    "overhang_speed_": SPEEDS, "ironing_": {"ironing": "1"}, "zaa_": {"zaa_enabled": "1"}, "fuzzy_skin_": {"fuzzy_skin": "external"}, "infill_goal": {"fill_pattern": "auto"},
    "scarf_seam_": {"scarf_seam_placement": "everywhere"}, "infill_smoothing": {"fill_pattern": "medialaxis"},
    "infill_anchor": {"infill_anchor": "600%", "infill_anchor_max": "50"}, "small_area_infill_flow_compensation_model": {
        "small_area_infill_flow_compensation": "1"},
    "automatic_infill_combination": {"layer_height": "0.15", "first_layer_height": "0.15"},
    "automatic_infill_combination_max_layer_height": {"automatic_infill_combination": "1"}, "gap_fill_": {"perimeter_generator": "classic"},
    "scarf_seam_max_overhang": {"scarf_seam_smooth_angle": "60"}, "scarf_seam_on_inner_perimeters": {"scarf_seam_only_on_smooth": "0"}, "thin_walls": {"perimeter_generator": "classic"}, "extra_perimeters": {"perimeters": "1"},
    "fuzzy_skin_scale": {"fuzzy_skin_noise_type": "perlin"}, "fuzzy_skin_octaves": {"fuzzy_skin_noise_type": "perlin"},
    "fuzzy_skin_persistence": {"fuzzy_skin_noise_type": "perlin"}, "fuzzy_skin_ripple": {"fuzzy_skin_noise_type": "ripple"},
    "fuzzy_skin_layers_between_ripple_offset": {"fuzzy_skin_noise_type": "ripple"},
    "lateral_lattice_": {"fill_pattern": "laterallattice"}, "infill_overhang_angle": {"fill_pattern": "lateralhoneycomb"},
    "infill_shift_step": {"fill_pattern": "crosszag"}, "symmetric_infill_y_axis": {"fill_pattern": "zigzag"},
    "skin_infill_": {"fill_pattern": "lockedzag"}, "skeleton_infill_": {"fill_pattern": "lockedzag"},
    "infill_lock_depth": {"fill_pattern": "lockedzag"}, "gyroid_optimized": {"fill_pattern": "gyroid"}, "separated_infills": {"fill_pattern": "honeycomb"},
    "sparse_infill_smooth_factor": {"fill_pattern": "honeycomb"}, "lightning_": {"fill_pattern": "lightning"},
    "wall_maximum_": {"wall_maximum_deviation": "0.1", "gcode_resolution": "0"}, "top_surface_expansion_": {"top_surface_expansion": "2"}, "relative_bridge_angle": {"bridge_angle": "30", "internal_bridge_angle": "30"},
    "top_surface_fill_order": {"top_fill_pattern": "concentric"}, "bottom_surface_fill_order": {"bottom_fill_pattern": "concentric"},
    "center_of_surface_pattern": {"top_fill_pattern": "archimedeanchords"},
    "dont_filter_internal_bridges": {"perimeters": "1", "solid_infill_below_area": "0", "fill_density": "10%"},
    "overhang_reverse_": {"overhang_reverse": "1"}, "min_width_top_surface": {"top_one_perimeter_type": "top"},
    "top_solid_min_thickness": {"top_solid_layers": "1"}, "bottom_solid_min_thickness": {"bottom_solid_layers": "1"}}
# Settings that only have an effect in a copy that is turned by a right angle. All its beads are compared.
TURNED = {"align_infill_direction_to_model"}
# Settings without effect on the whole part, because the part is one connected body.
WITHOUT = {("separated_infills", "heights")}
# Values for settings where half or twice the default does not show the effect.
VALUES = {
    "density_field": ['{"kind":"constant","density":0.5}'], "stress_field": ['{"kind":"constant","stress":[1,0,0]}'],
    "fill_angle_template": ["10,70"], "solid_fill_angle_template": ["10,70"], "bridge_angle": ["30"], "fill_angle": ["20"],
    "small_area_infill_flow_compensation_model": ["0,0;5,0.5;20,1"], "infill_every_layers": ["2"], "solid_infill_every_layers": ["3"],
    "top_solid_min_thickness": ["1.2"], "bottom_solid_min_thickness": ["1.2"], "solid_infill_below_area": ["0", "300"], "over_bridge_speed": ["33"],
    "top_layer_direction": ["20"], "bottom_layer_direction": ["20"], "internal_bridge_angle": ["30"], "top_surface_expansion": ["2"],
    "lightning_overhang_angle": ["80", "10"], "lightning_prune_angle": ["80"], "lightning_straightening_angle": ["80"],
    "extra_solid_infills": ["3"], "min_length_factor": ["30"], "top_surface_density": ["50"], "bottom_surface_density": ["50"], "fuzzy_skin_ripples_per_layer": ["31"],
    "gap_fill_min_length": ["3"], "solid_fill_angle": ["20"], "top_bottom_infill_overlap": ["0.3"], "min_width_top_surface": ["3", "15"],
    "overhang_reverse_threshold": ["0", "2"], "scarf_seam_steps": ["100"], "scarf_seam_speed": ["10"],
    "internal_bridge_speed": ["33"], "internal_bridge_flow": ["0.8"], "ironing_inset": ["1"],
    "wall_maximum_resolution": ["5"], "perimeters": ["5"], "infill_anchor_max": ["2"], "top_solid_layers": ["5"], "bottom_solid_layers": ["5"], "scarf_seam_start_height": ["50%"],
    "automatic_infill_combination_max_layer_height": ["50%"], "gap_fill_max_width": ["0.3"], "gap_fill_min_width": ["0.4"]}


def cone(x, y, z0, z1, r0, r1, corners=4):
    """Returns a frustum; with four corners, its sides are parallel to the axes."""
    def ring(z, r):
        return [(x + r * math.cos(2 * math.pi * (i + 0.5) / corners), y + r * math.sin(2 * math.pi * (i + 0.5) / corners), z) for i in range(corners)]
    n = corners
    faces = [(0, i + 1, i) for i in range(1, n - 1)] + [(n, n + i, n + i + 1) for i in range(1, n - 1)]
    faces += [f for i in range(n) for f in ((i, (i + 1) % n, n + i), ((i + 1) % n, n + (i + 1) % n, n + i))]
    return ring(z0, r0) + ring(z1, r1), faces


def box(x0, y0, z0, x1, y1, z1):
    corners, faces = cube(0, 0, 0, 1)
    return [(x0 + x * (x1 - x0), y0 + y * (y1 - y0), z0 + z * (z1 - z0)) for x, y, z in corners], faces


def wedge(x0, x1, y, z0, z1, thin, thick):
    """Returns a fin of width `thin` at x0 and `thick` at x1."""
    corners = [(x, y + side * width / 2, z) for z in (z0, z1) for x, side, width in
               ((x0, -1, thin), (x1, -1, thick), (x1, 1, thick), (x0, 1, thin))]
    return corners, [(0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7)] + [f for i in range(4) for f in ((i, (i + 1) % 4, 4 + i), ((i + 1) % 4, 4 + (i + 1) % 4, 4 + i))]


PART = (box(-14, 0, 0, 58, 30, 3), box(2, 4, 2, 5, 16, 6), box(15, 4, 2, 18, 16, 6), box(2, 4, 5.4, 18, 8, 7.5), box(2, 12, 5.4, 18, 16, 7.5), box(2, 7, 5.4, 8, 13, 7.5), box(12, 7, 5.4, 18, 13, 7.5), wedge(2, 18, 24, 2, 5, 0.3, 1.7),
        cone(26, 7, 2, 6, 3, 8.5), cone(26, 22, 2, 4.5, 3, 9), cone(39, 7, 2, 5, 1.5, 1.5, 16), cone(10, 10, 7, 9, 8, 2),
        box(47, 8, 2, 50, 22, 6), box(47, 8, 5.4, 56, 22, 7))
MODIFIER = box(-1, -5, -1, 70, 40, 20)
HEIGHTS = (0, 20)


def metadata(settings):
    return "".join(f'<metadata type="volume" key="{key}" value="{value.replace(chr(34), "&quot;")}"/>' for key, value in settings.items())


def project(job, modifier=None, heights=None, turned=False):
    meshes = [*PART, MODIFIER] if modifier is not None else PART
    faces = sum(len(mesh[1]) for mesh in PART)
    files = {"3D/3dmodel.model": model_xml(f'<object id="1" type="model">{mesh_xml(*meshes)}</object>', item(1, 100, 100, turned), "PrusaSlicer-2.9.2"),
             "Metadata/Slic3r_PE.config": "".join(f"; {key} = {value}\n" for key, value in (JOB | job).items())}
    if modifier is not None:
        files["Metadata/Slic3r_PE_model.config"] = (
            f'<config><object id="1"><volume firstid="0" lastid="{faces - 1}"><metadata type="volume" key="volume_type" value="ModelPart"/></volume>'
            f'<volume firstid="{faces}" lastid="{faces + 11}"><metadata type="volume" key="volume_type" value="ParameterModifier"/>{metadata(modifier)}'
            "</volume></object></config>")
    if heights is not None:
        options = "".join(f'<option opt_key="{key}">{value.replace(chr(34), "&quot;")}</option>' for key, value in heights.items())
        files["Metadata/Prusa_Slicer_layer_config_ranges.xml"] = (
            f'<objects><object id="1"><range min_z="{HEIGHTS[0]}" max_z="{HEIGHTS[1]}">{options}</range></object></objects>')
    return files


def beads_of(gcode):
    """Returns the beads as (middle x, middle z, all values that describe the bead)."""
    beads, feature, height = [], "", ""
    x = y = z = speed = 0.0
    for line in gcode.splitlines():
        if line.startswith(";TYPE:"):
            feature = line
        elif line.startswith(";HEIGHT:"):
            height = line
        elif line.startswith("G1 "):
            words = {letter: float(value) for letter, value in re.findall(r"([XYZEF])(-?\d*\.?\d+)", line.split(";")[0])}
            before, (x, y, z), speed = (x, y), (words.get("X", x), words.get("Y", y), words.get("Z", z)), words.get("F", speed)
            if words.get("E", 0) > 0 and before != (x, y):
                beads.append(((before[0] + x) / 2, z, (before, x, y, z, words["E"], speed, feature, height)))
    return beads


class Slicer:
    def __init__(self, program, folder):
        self.program, self.folder, self.known = program, folder, {}

    def __call__(self, job, **places):
        """Returns the beads and the messages of the report; if the part is refused, no beads and the error."""
        key = json.dumps([job, places], sort_keys=True)
        if key not in self.known:
            path = write(self.folder / "part.3mf", project(job, **places))
            done = run(self.program, "slice", path, "-o", self.folder / "out.gcode", "--report", self.folder / "report.json", "-q",
                       "--set", "use_relative_e_distances=1")
            if done.returncode:
                return [], done.stderr
            told = json.loads((self.folder / "report.json").read_text())
            self.known[key] = beads_of((self.folder / "out.gcode").read_text()), json.dumps([told["warnings"], told["settings_without_effect"], told.get("notes")])
        return self.known[key]


def context_of(key):
    job = {}
    for start in sorted(CONTEXTS, key=len):
        if key.startswith(start):
            job |= CONTEXTS[start]
    return job


def values_of(setting, job):
    key, now = setting["key"], (JOB | job).get(setting["key"], setting["default"])
    if key in VALUES:
        return VALUES[key]
    if setting.get("choices"):
        return [choice for choice in setting["choices"] if choice != now]
    if setting["range"] == "0 or 1":
        return ["1" if now == "0" else "0"]
    number, sign = float(now.rstrip("%")), "%" if now.endswith("%") else ""
    return [f"{value:g}{sign}" for value in ((number / 2, number * 2) if number else (0.6,))]


def inside(beads, place, key):
    if key in TURNED:
        return [bead[2] for bead in beads]
    low, high = (100 - 1, math.inf) if place == "modifier" else HEIGHTS
    axis = 0 if place == "modifier" else 1
    return [bead[2] for bead in beads if low < bead[axis] < high]


def effect(slicer, setting, place):
    """Returns None if the setting has an effect in the place (modifier or heights), else a text with the values tried."""
    key = setting["key"]
    job = context_of(key)
    turned = {"turned": True} if key in TURNED else {}
    base = inside(slicer(job, **{place: {}}, **turned)[0], place, key)
    assert len(base) > 100, f"{key}: the part has no beads in the {place}"
    tried = []
    for value in values_of(setting, job):
        beads, told = slicer(job, **{place: {key: value}}, **turned)
        if key in told or beads and inside(beads, place, key) != base:
            return None
        tried.append(value)
    return f"{key} = {' or '.join(tried)} in a {place}: the G-code is as before, and nothing is told"


def main():
    program = sys.argv[1]
    table = [s for s in json.loads(must(program, "settings", "--json")) if s["scope"] == "region"]
    assert len(table) > 70, len(table)
    with tempfile.TemporaryDirectory() as folder:
        slicer = Slicer(program, pathlib.Path(folder))
        silent = [text for setting in table for place in ("modifier", "heights")
                  if (setting["key"], place) not in WITHOUT and (text := effect(slicer, setting, place))]
    assert not silent, "\n".join(silent)


if __name__ == "__main__":
    main()
    sys.stdout.flush()
    os._exit(0)
