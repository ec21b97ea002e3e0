#include "processes/engrave/settings/engrave_table.h"

#include <algorithm>
#include <iterator>

#include "common/config/table/bind.h"
#include "processes/engrave/model/engrave_settings.h"

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
      Text("texture", "bumps",
           "A computed texture, kind:key=value,... (bumps, cones, pyramids, grooves, waves, "
           "hexagons, weave, letters, cells, noise, scales, knurl), or the name of the object "
           "that is one: a planar solid",
           Bind<&EngraveSettings::texture, &TextureSettings::texture>()),
      Text("texture_image", "", "The texture as a height image: a PNG file in base64",
           Bind<&EngraveSettings::texture, &TextureSettings::image>()),
      Text("mask_image", "",
           "A PNG file in base64, laid over the map's box: works where it is bright",
           Bind<&EngraveSettings::texture, &TextureSettings::mask>()),
      Number("texture_width", {"mm", 0.001, 10'000}, "20", "Of a height image",
             Bind<&EngraveSettings::texture, &TextureSettings::width_mm>()),
      Number("texture_height", {"mm", 0.001, 1000}, "0.5", "Of a height image's white",
             Bind<&EngraveSettings::texture, &TextureSettings::height_mm>()),
      Text("texture_pitch", "", "Of an object's repetitions, mm: X,Y; empty: its box",
           Bind<&EngraveSettings::texture, &TextureSettings::pitch>()),
      Number("texture_scale", {"", 0.001, 1000}, "1", "Of the texture's width and length",
             Bind<&EngraveSettings::texture, &TextureSettings::scale>()),
      Text("anchor", "",
           "Where on the surface the texture's origin lies, mm: X,Y,Z; empty: in the map's middle",
           Bind<&EngraveSettings::texture, &TextureSettings::anchor>()),
      Text("orient", "", "Along which the texture's x runs there: X,Y,Z; empty: the map's x",
           Bind<&EngraveSettings::texture, &TextureSettings::orient>()),
      Number("texture_turn", {"degrees", -360, 360}, "0", "Further, counter-clockwise",
             Bind<&EngraveSettings::texture, &TextureSettings::turn_deg>()),
      Flag("texture_once", "0", "One tile, its middle at the anchor; else repeated",
           Bind<&EngraveSettings::texture, &TextureSettings::once>()),
      Number("margin", {"mm", 0, 10'000}, "0", "To the surface's boundary, in the map",
             Bind<&EngraveSettings::texture, &TextureSettings::margin_mm>()),
      Flag("engraved", "0", "Into the surface; else onto it",
           Bind<&EngraveSettings::texture, &TextureSettings::engraved>()),
      Flag("outside", "0", "What is not the texture is worked, from its top down",
           Bind<&EngraveSettings::texture, &TextureSettings::outside>()),
  };
}

std::vector<SettingSpec> LineTable() {
  return {
      Number("layer_height", {"mm", 0.0001, 1000}, "0.05", "Most between two layers",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::layer_height_mm>()),
      Text("spacing", "0.1", "Of lines, mm; several by commas: of layer after layer",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::spacing>()),
      Text("angle", "0", "Of lines to the texture's x, degrees; of layer after layer",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::angle>()),
      Flag("equidistant", "0", "Lines bend to lie as far apart on the surface as asked",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::equidistant>()),
      {.key = "normals",
       .kind = Kind::kChoice,
       .standard = "faces",
       .doc = "Along which points are lifted: of faces, or interpolated between vertices",
       .choices = {Named("faces", NormalKind::kFaces),
                   Named("interpolated", NormalKind::kInterpolated)},
       .field = Bind<&EngraveSettings::lines, &EngraveLineSettings::normals>()},
      Flag("connect", "1", "Lines are joined at their ends",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::connect>()),
      Number("clearance", {"mm", 0, 1000}, "0", "Of links, above all; 0: at their layer",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::clearance_mm>()),
      Number("shortest", {"mm", 0, 1000}, "0", "Shorter parts of lines are left out",
             Bind<&EngraveSettings::lines, &EngraveLineSettings::shortest_mm>()),
      Flag("seam", "1", "A surface that is no disk is cut open; else refused",
           Bind<&EngraveSettings::lines, &EngraveLineSettings::seam>()),
  };
}

std::vector<SettingSpec> MachineTable() {
  return {
      {.key = "axes",
       .kind = Kind::kChoice,
       .standard = "table-bc",
       .doc = "What turns, besides X, Y and Z",
       .choices = {Named("none", AxisLayout::kNone), Named("table-ab", AxisLayout::kTableAb),
                   Named("table-bc", AxisLayout::kTableBc), Named("head-ab", AxisLayout::kHeadAb),
                   Named("head-bc", AxisLayout::kHeadBc)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::axes>()},
      {.key = "tool",
       .kind = Kind::kChoice,
       .standard = "beam",
       .doc = "What works",
       .choices = {Named("beam", ToolKind::kBeam), Named("spindle", ToolKind::kSpindle),
                   Named("extruder", ToolKind::kExtruder)},
       .field = Bind<&EngraveSettings::machine, &EngraveMachineSettings::tool>()},
      Text("centre", "", "Where a table's axes meet, mm: X,Y,Z; empty: the origin",
           Bind<&EngraveSettings::machine, &EngraveMachineSettings::centre>()),
      Number("pivot", {"mm", 0, 10'000}, "100", "From a head's axes to the tip",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::pivot_mm>()),
      Number("tilt", {"degrees", 0, 180}, "110", "Most of A and B, either way",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::tilt_deg>()),
      Number("steepest", {"degrees", 0, 90}, "60", "Of the surface, without such axes",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::steepest_deg>()),
      Number("power", {"", 0, 1e6}, "1000", "S: of a beam, or turns a minute",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::power>()),
      Number("feed", {"mm/min", 0.1, 1e6}, "1200", "Of the tip over the surface",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::feed_mm_min>()),
      Number("link_feed", {"mm/min", 0.1, 1e6}, "6000", "Of the tip between lines",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::link_mm_min>()),
      Number("turn_feed", {"degrees/min", 0.1, 1e7}, "7200", "Most of a rotary axis",
             Bind<&EngraveSettings::machine, &EngraveMachineSettings::turn_deg_min>()),
      {.key = "output_format",
       .kind = Kind::kChoice,
       .standard = "csv",
       .doc = "Points with normals (csv), a program (gcode), the surface with the texture in it "
              "(stl, obj), a picture of the lines over the surface (png), or a picture of the map "
              "and its distortion (map_png)",
       .choices = {Named("csv", EngraveFormat::kCsv), Named("gcode", EngraveFormat::kGcode),
                   Named("stl", EngraveFormat::kStl), Named("obj", EngraveFormat::kObj),
                   Named("png", EngraveFormat::kPng), Named("map_png", EngraveFormat::kMapPng)},
       .field = Bind<&EngraveSettings::format>()},
      Number("displaced_edge", {"mm", 0.001, 1000}, "0.2",
             "Longest edge of the triangles of a surface with the texture in it",
             Bind<&EngraveSettings::displaced_edge_mm>()),
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
