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
           "Height image used as the texture, a PNG file in base64; replaces `texture`",
           Bind<&EngraveSettings::texture, &TextureSettings::image>()),
      Text("mask_image", "",
           "Mask image, a PNG file in base64, that covers the bounding box of the surface's flat "
           "map: only bright areas are worked; empty: the whole surface",
           Bind<&EngraveSettings::texture, &TextureSettings::mask>()),
      Needing({&needs::kImage},
              Number("texture_width", {"mm", 0.001, 10'000}, "20",
                     "Width of texture_image on the surface",
                     Bind<&EngraveSettings::texture, &TextureSettings::width_mm>())),
      Needing({&needs::kImage},
              Number("texture_height", {"mm", 0.001, 1000}, "0.5",
                     "Height of the texture where texture_image is white",
                     Bind<&EngraveSettings::texture, &TextureSettings::height_mm>())),
      Needing({&needs::kNoImage},
              Text("texture_pitch", "",
                   "Distances in x and y at which an object used as the texture repeats: X,Y in "
                   "mm; empty: the size of the object's bounding box",
                   Bind<&EngraveSettings::texture, &TextureSettings::pitch>())),
      Number("texture_scale", {"", 0.001, 1000}, "1",
             "Scale of the texture in width and length; 1: original size",
             Bind<&EngraveSettings::texture, &TextureSettings::scale>()),
      Text("anchor", "",
           "Point on the surface where the origin of the texture is placed: X,Y,Z in mm; empty: "
           "the middle of the surface's flat map",
           Bind<&EngraveSettings::texture, &TextureSettings::anchor>()),
      Text("orient", "",
           "Direction of the texture's x axis at the anchor: X,Y,Z; empty: the x axis of the "
           "surface's flat map",
           Bind<&EngraveSettings::texture, &TextureSettings::orient>()),
      Number(
          "texture_turn", {"degrees", -360, 360}, "0",
          "Angle by which the texture is turned counter-clockwise from the direction in `orient`",
          Bind<&EngraveSettings::texture, &TextureSettings::turn_deg>()),
      Flag("texture_once", "0", "Place a single tile, centred on the anchor; 0: repeat the texture",
           Bind<&EngraveSettings::texture, &TextureSettings::once>()),
      Number("margin", {"mm", 0, 10'000}, "0",
             "Width of a border of the surface that remains untouched, measured in the flat map",
             Bind<&EngraveSettings::texture, &TextureSettings::margin_mm>()),
      Flag("engraved", "0", "Work the texture into the surface; 0: build it up on the surface",
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
             "Largest height of a layer; the layers of a texture are equally high",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::layer_height_mm>()),
      Text("spacing", "0.1",
           "Distances between lines, in mm; several values, separated by commas, apply to the "
           "layers in turn",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::spacing>()),
      Text("angle", "0",
           "Directions of the lines, counter-clockwise from the texture's x axis, in degrees; "
           "several values, separated by commas, apply to the layers in turn",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::angle>()),
      Flag("equidistant", "0",
           "Bend lines so that their distance on the surface is the requested spacing everywhere",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::equidistant>()),
      {.key = "normals",
       .kind = Kind::kChoice,
       .standard = "faces",
       .doc = "Normals along which points are lifted from the surface. faces: normals of the "
              "triangles. interpolated: normals interpolated between the vertices",
       .choices = {Named("faces", NormalKind::kFaces),
                   Named("interpolated", NormalKind::kInterpolated)},
       .field = Bind<&EngraveSettings::lines, &EngraveLineSettings::normals>()},
      Flag("connect", "1", "Connect neighbouring lines at their ends",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::connect>()),
      Number("clearance", {"mm", 0, 1000}, "0",
             "Height of the links between lines above the surface and the texture worked so far; "
             "0: links stay at the height of their layer",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::clearance_mm>()),
      Number("shortest", {"mm", 0, 1000}, "0",
             "Length below which parts of lines are omitted; 0: no part is omitted",
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
       .doc = "Rotary axes of the machine, besides X, Y and Z: two of the table (table-ab, "
              "table-bc) or of the head (head-ab, head-bc); none: the tool points down",
       .choices = {Named("none", AxisLayout::kNone), Named("table-ab", AxisLayout::kTableAb),
                   Named("table-bc", AxisLayout::kTableBc), Named("head-ab", AxisLayout::kHeadAb),
                   Named("head-bc", AxisLayout::kHeadBc)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::axes>(),
       .needs = {&needs::kProgram}},
      {.key = "tool",
       .kind = Kind::kChoice,
       .standard = "beam",
       .doc = "Tool of the machine: a beam, a spindle or an extruder",
       .choices = {Named("beam", ToolKind::kBeam), Named("spindle", ToolKind::kSpindle),
                   Named("extruder", ToolKind::kExtruder)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::tool>(),
       .needs = {&needs::kProgram}},
      Needing({&needs::kProgram},
              Text("centre", "",
                   "Point where the rotary axes of a table meet: X,Y,Z in mm; empty: the origin",
                   Bind<&EngraveSettings::machine, &EngraveMachineSettings::centre>())),
      Needing({&needs::kProgram},
              Number("pivot", {"mm", 0, 10'000}, "100",
                     "Distance from the rotary axes of a head to the tip of the tool",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::pivot_mm>())),
      Needing({&needs::kProgram},
              Number("tilt", {"degrees", 0, 180}, "110",
                     "Largest angle of the rotary axes A and B, in either direction",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::tilt_deg>())),
      Needing({&needs::kProgram},
              Number("steepest", {"degrees", 0, 90}, "60",
                     "Steepest slope of the surface, measured from horizontal, that a machine "
                     "without rotary axes may work",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::steepest_deg>())),
      Needing(
          {&needs::kProgram},
          Number(
              "power", {"", 0, 1e6}, "1000",
              "Value of S in the program: power of a beam, or revolutions per minute of a spindle",
              Bind<&EngraveSettings::machine, &EngraveMachineSettings::power>())),
      Needing({&needs::kProgram},
              Number("feed", {"mm/min", 0.1, 1e6}, "1200", "Speed of the tip over the surface",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::feed_mm_min>())),
      Needing({&needs::kProgram},
              Number("link_feed", {"mm/min", 0.1, 1e6}, "6000", "Speed of the tip between lines",
                     Bind<&EngraveSettings::machine, &EngraveMachineSettings::link_mm_min>())),
      Needing(
          {&needs::kProgram},
          Number("turn_feed", {"degrees/min", 0.1, 1e7}, "7200", "Largest speed of a rotary axis",
                 Bind<&EngraveSettings::machine, &EngraveMachineSettings::turn_deg_min>())),
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "csv",
       .doc = "File that is written. csv: points with normals. gcode: a machine program. stl, obj: "
              "the textured surface. png: a picture of the lines on the surface. map_png: a "
              "picture of the map and its distortion",
       .choices = {Named("csv", EngraveFormat::kCsv), Named("gcode", EngraveFormat::kGcode),
                   Named("stl", EngraveFormat::kStl), Named("obj", EngraveFormat::kObj),
                   Named("png", EngraveFormat::kPng), Named("map_png", EngraveFormat::kMapPng)},
       .field = Bind<&EngraveSettings::format>()},
      Needing(
          {&needs::kMesh},
          Number(
              "displaced_edge", {"mm", 0.001, 1000}, "0.2",
              "Longest triangle edge of the written textured surface (stl, obj); smaller: finer, "
              "larger files",
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
