#include "processes/engrave/settings/engrave_table.h"

#include <algorithm>
#include <iterator>

#include "common/config/table/bind.h"
#include "processes/engrave/model/engrave_settings.h"
#include "processes/engrave/settings/needs.h"

namespace slicefarm::config::engrave {
namespace {

template <class Enum>
Choice Named(std::string_view name, Enum value) {
  return {name, static_cast<int>(value)};
}

struct Range {
  std::string_view unit;
  double min = 0;
  double max = 0;
};

SettingSpec Number(std::string_view key, Range range, std::string_view standard,
                   std::string_view doc, Field field) {
  return {.key = key,
          .unit = range.unit,
          .min = range.min,
          .max = range.max,
          .standard = standard,
          .doc = doc,
          .field = field};
}

SettingSpec Flag(std::string_view key, std::string_view standard, std::string_view doc,
                 Field field) {
  return {.key = key, .kind = Kind::kFlag, .standard = standard, .doc = doc, .field = field};
}

SettingSpec Text(std::string_view key, std::string_view standard, std::string_view doc,
                 Field field) {
  return {.key = key, .kind = Kind::kText, .standard = standard, .doc = doc, .field = field};
}

std::vector<SettingSpec> TextureTable() {
  return {
      Needing({&needs::kNoImage},
              Text("texture", "bumps",
                   "Texture: a computed one as KIND:KEY=VALUE,... or the name of an object that is "
                   "a flat solid. Kinds: bumps, cones, pyramids, grooves, waves, hexagons, weave, "
                   "letters, cells, noise, scales, knurl",
                   Bind<&EngraveSettings::texture, &TextureSettings::texture>())),
      Text("texture_image", "",
           "Height image that is used as the texture instead of `texture`: a PNG file in base64. "
           "Empty: `texture`",
           Bind<&EngraveSettings::texture, &TextureSettings::image>()),
      Text("mask_image", "",
           "Mask image, a PNG file in base64, that covers the bounding box of the flattened "
           "surface. Only bright areas are worked. Empty: the whole surface",
           Bind<&EngraveSettings::texture, &TextureSettings::mask>()),
      Needing({&needs::kImage},
              Number("texture_width", {"mm", 0.001, 10'000}, "20",
                     "Width of texture_image on the surface",
                     Bind<&EngraveSettings::texture, &TextureSettings::width_mm>())),
      Needing({&needs::kImage},
              Number("texture_height", {"mm", 0.001, 1000}, "0.5",
                     "Height of the texture where texture_image is white; where texture_image is "
                     "black, the height is 0",
                     Bind<&EngraveSettings::texture, &TextureSettings::height_mm>())),
      Needing({&needs::kNoImage},
              Text("texture_pitch", "",
                   "Distances in x and y at which an object in `texture` is repeated: X,Y in mm; "
                   "empty: the size of the object's bounding box",
                   Bind<&EngraveSettings::texture, &TextureSettings::pitch>())),
      Number("texture_scale", {"", 0.001, 1000}, "1",
             "Factor for the width and length of the texture; 1: original size",
             Bind<&EngraveSettings::texture, &TextureSettings::scale>()),
      Text("anchor", "",
           "Point on the surface where the origin of the texture is placed: X,Y,Z in mm. Empty: "
           "the middle of the flattened surface",
           Bind<&EngraveSettings::texture, &TextureSettings::anchor>()),
      Text("orient", "",
           "Direction on the surface, at `anchor`, of the texture's x axis: X,Y,Z. Empty: the x "
           "axis of the flattened surface",
           Bind<&EngraveSettings::texture, &TextureSettings::orient>()),
      Number(
          "texture_turn", {"degrees", -360, 360}, "0",
          "Angle by which the texture is turned counter-clockwise from the direction in `orient`",
          Bind<&EngraveSettings::texture, &TextureSettings::turn_deg>()),
      Flag("texture_once", "0",
           "Place a single tile of the texture, centred on `anchor`; 0: repeat the texture over "
           "the surface",
           Bind<&EngraveSettings::texture, &TextureSettings::once>()),
      Number("margin", {"mm", 0, 10'000}, "0",
             "Width of a border of the surface that remains untouched, measured after the surface "
             "has been laid flat; 0: no border",
             Bind<&EngraveSettings::texture, &TextureSettings::margin_mm>()),
      Flag("engraved", "0", "Engrave the texture into the surface; 0: build it up on the surface",
           Bind<&EngraveSettings::texture, &TextureSettings::engraved>()),
      Flag("outside", "0",
           "Work the area around the texture, from the top of the texture down; 0: work the "
           "texture itself",
           Bind<&EngraveSettings::texture, &TextureSettings::outside>()),
  };
}

std::vector<SettingSpec> LineTable() {
  return {
      Number("layer_height", {"mm", 0.0001, 1000}, "0.05",
             "Largest height of the layers in which the texture is worked; all layers of a texture "
             "are equally high",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::layer_height_mm>()),
      Text("spacing", "0.1",
           "Distances between neighbouring lines, in mm. Several values, separated by commas, "
           "apply to the layers in turn",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::spacing>()),
      Text("angle", "0",
           "Directions of the lines in degrees, counter-clockwise from the texture's x axis. "
           "Several values, separated by commas, apply to the layers in turn",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::angle>()),
      Flag("equidistant", "0",
           "Bend lines so that their distance on the curved surface is `spacing` everywhere; 0: "
           "straight lines in the flat surface, with varying distances on the curved one",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::equidistant>()),
      {.key = "normals",
       .kind = Kind::kChoice,
       .standard = "faces",
       .doc = "Directions in which points of the texture are moved off the surface. faces: "
              "perpendicular to the triangles. interpolated: interpolated between the vertices, "
              "for smooth surfaces",
       .choices = {Named("faces", NormalKind::kFaces),
                   Named("interpolated", NormalKind::kInterpolated)},
       .field = Bind<&EngraveSettings::lines, &EngraveLineSettings::normals>()},
      Flag("connect", "1",
           "Connect neighbouring lines at their ends, so that the tool works without interruption; "
           "0: lines are separate",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::connect>()),
      Number("clearance", {"mm", 0, 1000}, "0",
             "Height of the moves between lines above the surface and the texture worked so far; "
             "0: these moves stay at the height of their layer",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::clearance_mm>()),
      Number("shortest", {"mm", 0, 1000}, "0",
             "Length below which pieces of lines are omitted; 0: all are worked",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::shortest_mm>()),
      Flag("seam", "1",
           "Cut a surface open if it cannot be laid flat in one piece, such as a sphere or a tube; "
           "0: refuse such a surface",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::seam>()),
  };
}

std::vector<SettingSpec> MachineTable() {
  return {
      {.key = "axes",
       .kind = Kind::kChoice,
       .standard = "table-bc",
       .doc = "Rotary axes of the machine, in addition to X, Y and Z. table-ab, table-bc: axes A "
              "and B, or B and C, of the table. head-ab, head-bc: of the head. none: no rotary "
              "axes; the tool always points down",
       .choices = {Named("none", AxisLayout::kNone), Named("table-ab", AxisLayout::kTableAb),
                   Named("table-bc", AxisLayout::kTableBc), Named("head-ab", AxisLayout::kHeadAb),
                   Named("head-bc", AxisLayout::kHeadBc)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::axes>(),
       .needs = {&needs::kProgram}},
      {.key = "tool",
       .kind = Kind::kChoice,
       .standard = "beam",
       .doc = "Tool of the machine. beam: a beam of light. spindle: a rotating cutter. extruder: "
              "an extruder that builds the texture up",
       .choices = {Named("beam", ToolKind::kBeam), Named("spindle", ToolKind::kSpindle),
                   Named("extruder", ToolKind::kExtruder)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::tool>(),
       .needs = {&needs::kProgram}},
      Needing({&needs::kProgram},
              Text("centre", "",
                   "Point where the rotary axes of a table meet: X,Y,Z in mm; empty: the origin of "
                   "the machine's coordinates",
                   Bind<&EngraveSettings::machine, &EngraveMachineSettings::centre>())),
      Needing({&needs::kProgram},
              Number("pivot", {"mm", 0, 10'000}, "100",
                     "Distance from the rotary axes of a head to the tip of the tool",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::pivot_mm>())),
      Needing({&needs::kProgram},
              Number("tilt", {"degrees", 0, 180}, "110",
                     "Largest angle of the rotary axes A and B from 0, in either direction",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::tilt_deg>())),
      Needing({&needs::kProgram},
              Number("steepest", {"degrees", 0, 90}, "60",
                     "Steepest slope of the surface, measured from horizontal, that is accepted "
                     "with axes = none",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::steepest_deg>())),
      Needing({&needs::kProgram},
              Number("power", {"", 0, 1e6}, "1000",
                     "Value of S in the program. tool = beam: power of the beam. tool = spindle: "
                     "revolutions per minute",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::power>())),
      Needing({&needs::kProgram},
              Number("feed", {"mm/min", 0.1, 1e6}, "1200", "Speed of the tool's tip along lines",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::feed_mm_min>())),
      Needing(
          {&needs::kProgram},
          Number("link_feed", {"mm/min", 0.1, 1e6}, "6000", "Speed of the tool's tip between lines",
                 Bind<&EngraveSettings::machine, &EngraveMachineSettings::link_mm_min>())),
      Needing({&needs::kProgram},
              Number("turn_feed", {"degrees/min", 0.1, 1e7}, "7200",
                     "Largest speed of each rotary axis",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::turn_deg_min>())),
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "csv",
       .doc = "File that is written. csv: points with normals. gcode: a machine program. stl, obj: "
              "the textured surface. png: a picture of the lines on the surface. map_png: a "
              "picture of the surface laid flat, with its distortion",
       .choices = {Named("csv", EngraveFormat::kCsv), Named("gcode", EngraveFormat::kGcode),
                   Named("stl", EngraveFormat::kStl), Named("obj", EngraveFormat::kObj),
                   Named("png", EngraveFormat::kPng), Named("map_png", EngraveFormat::kMapPng)},
       .field = Bind<&EngraveSettings::format>()},
      Needing({&needs::kMesh}, Number("displaced_edge", {"mm", 0.001, 1000}, "0.2",
                                      "Longest edge of the triangles in a textured surface that is "
                                      "written as stl or obj; smaller: finer texture, larger file",
                                      Bind<&EngraveSettings::displaced_edge_mm>())),
  };
}

}  // namespace

std::vector<SettingSpec> EngraveTable() {
  std::vector<SettingSpec> all = TextureTable();
  for (const auto& section : {LineTable, MachineTable})
    std::ranges::move(section(), std::back_inserter(all));
  return all;
}

}  // namespace slicefarm::config::engrave
