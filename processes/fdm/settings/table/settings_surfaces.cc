#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

template <auto kMember, Scale kScale = Scale::kSame>
Field Surface() {
  return Bind<kScale, &RegionRow::infill, &InfillOptions::surfaces, kMember>();
}

template <auto kMember, Scale kScale = Scale::kSame>
Field Bridge() {
  return Bind<kScale, &RegionRow::infill, &InfillOptions::bridges, kMember>();
}

/// Returns the field of a direction in degrees; -1 stands for no direction.
template <double SurfaceOptions::*kMember>
Field Direction() {
  constexpr double kDegree = std::numbers::pi / 180;
  return Convert<RegionRow>(
      [](RegionRow& row, const Value& value) {
        row.infill.surfaces.*kMember = value.number < 0 ? -1 : value.number * kDegree;
      },
      [](const RegionRow& row) {
        const double angle = row.infill.surfaces.*kMember;
        return Value{.number = angle < 0 ? -1 : Quantise(angle / kDegree)};
      });
}

SettingSpec LayerDirection(std::string_view key, std::string_view doc, Field field) {
  return {.key = key,
          .unit = "degrees",
          .min = -1,
          .max = 360,
          .standard = "-1",
          .doc = doc,
          .field = field,
          .orca = {{key}}};
}

SettingSpec OrderOf(std::string_view key, std::string_view doc, Field field) {
  const auto order = [](FillOrder value) { return static_cast<int>(value); };
  return {.key = key,
          .kind = Kind::kChoice,
          .standard = "default",
          .doc = doc,
          .choices = {{"default", order(FillOrder::kNearest)},
                      {"outward", order(FillOrder::kOutward)},
                      {"inward", order(FillOrder::kInward)}},
          .field = field,
          .orca = {{key}}};
}

std::vector<SettingSpec> Expansion() {
  const auto direction = [](ExpansionDirection value) { return static_cast<int>(value); };
  return {
      {.key = "top_surface_expansion",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Distance by which top surfaces grow under the features that stand on them, so that "
              "gaps close; the layers below become solid there too. Surfaces do not grow from one "
              "island to another, into walls or over bridges. 0: none",
       .field = Surface<&SurfaceOptions::expansion_nm>(),
       .orca = {{"top_surface_expansion"}}},
      {.key = "top_surface_expansion_margin",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "0",
       .doc = "Distance that grown top surfaces keep from the walls",
       .field = Surface<&SurfaceOptions::expansion_margin_nm>(),
       .orca = {{"top_surface_expansion_margin"}},
       .needs = {&needs::kTopExpansion}},
      {.key = "top_surface_expansion_direction",
       .kind = Kind::kChoice,
       .standard = "inward_and_outward",
       .doc = "Edges at which top surfaces grow. inward: the edges of holes. outward: the outer "
              "edges. inward_and_outward: all edges",
       .choices = {{"inward_and_outward", direction(ExpansionDirection::kBoth)},
                   {"inward", direction(ExpansionDirection::kInward)},
                   {"outward", direction(ExpansionDirection::kOutward)}},
       .field = Surface<&SurfaceOptions::expansion_direction>(),
       .orca = {{"top_surface_expansion_direction"}},
       .needs = {&needs::kTopExpansion}},
  };
}

std::vector<SettingSpec> Bridges() {
  const auto extra = [](ExtraBridges value) { return static_cast<int>(value); };
  return {
      {.key = "internal_bridge_angle",
       .unit = "degrees",
       .min = 0,
       .max = 360,
       .standard = "0",
       .doc = "Direction of the lines of bridges over sparse infill, from the x axis; 0: the best "
              "supported direction of each bridge. 180: along the x axis",
       .field = Bridge<&BridgeOptions::internal_angle_rad, Scale::kDegrees>(),
       .orca = {{"internal_bridge_angle"}}},
      {.key = "relative_bridge_angle",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Add bridge_angle and internal_bridge_angle to the best supported direction of each "
              "bridge; 0: they replace this direction",
       .field = Bridge<&BridgeOptions::relative>(),
       .orca = {{"relative_bridge_angle"}},
       .needs = {&needs::kBridgeAngle}},
      {.key = "bridge_line_width",
       .kind = Kind::kNumberOrPercent,
       .unit = "mm",
       .min = 0,
       .max = 5,
       .standard = "0",
       .doc = "Diameter of the round strands of bridges; width of their lines with thick_bridges = "
              "0. 0: the nozzle diameter for strands, solid_infill_extrusion_width for lines",
       .relative_to = "nozzle_diameter",
       .field = Bridge<&BridgeOptions::width_nm>(),
       .also = Bind<&RegionRow::motion, &RegionMotion::bridge_width_mm>(),
       .orca = {{"bridge_line_width"}}},
      {.key = "enable_extra_bridge_layer",
       .kind = Kind::kChoice,
       .standard = "disabled",
       .doc = "Bridges above which the next layer is printed as a bridge too, where it is solid. "
              "external_bridge_only: bridges over air; the second layer runs parallel to the "
              "first. internal_bridge_only: bridges over sparse infill; the second layer runs "
              "across the first. apply_to_all: both. The second layer has flat lines, because "
              "round strands would overfill it",
       .choices = {{"disabled", extra(ExtraBridges::kNone)},
                   {"external_bridge_only", extra(ExtraBridges::kExternal)},
                   {"internal_bridge_only", extra(ExtraBridges::kInternal)},
                   {"apply_to_all", extra(ExtraBridges::kAll)}},
       .field = Bridge<&BridgeOptions::extra>(),
       .orca = {{"enable_extra_bridge_layer"}}},
  };
}

}  // namespace

std::vector<SettingSpec> SurfaceSettings() {
  const auto center = [](SurfaceCenter value) { return static_cast<int>(value); };
  std::vector<SettingSpec> settings = {
      LayerDirection("top_layer_direction",
                     "Direction of the lines of top surfaces in all layers, from the x axis; -1: "
                     "the direction of other solid infill",
                     Direction<&SurfaceOptions::top_angle_rad>()),
      LayerDirection("bottom_layer_direction",
                     "Direction of the lines of bottom surfaces, except bridges, in all layers, "
                     "from the x axis; -1: the direction of other solid infill",
                     Direction<&SurfaceOptions::bottom_angle_rad>()),
      {.key = "align_infill_direction_to_model",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Turn the directions of infill, surfaces and given bridge angles with the object, if "
              "a copy of it is rotated about the z axis",
       .field = Bind<&RegionRow::infill, &InfillOptions::follows_model>(),
       .orca = {{"align_infill_direction_to_model"}}},
      OrderOf("top_surface_fill_order",
              "Order of the loops and spirals of top surfaces, for the patterns concentric, "
              "archimedeanchords and octagramspiral. outward: from the middle to the edge. inward: "
              "from the edge to the middle. default: the shortest travels",
              Surface<&SurfaceOptions::top_order>()),
      OrderOf("bottom_surface_fill_order",
              "Order of the loops and spirals of bottom surfaces, written as in "
              "top_surface_fill_order",
              Surface<&SurfaceOptions::bottom_order>()),
      {.key = "center_of_surface_pattern",
       .kind = Kind::kChoice,
       .standard = "each_assembly",
       .doc = "Middle of the spirals of top and bottom surfaces (archimedeanchords and "
              "octagramspiral). each_surface: the middle of each surface. each_model: the middle "
              "of each connected body of the object. each_assembly: the middle of the object, so "
              "that the spirals of all its surfaces fit together",
       .choices = {{"each_assembly", center(SurfaceCenter::kObject)},
                   {"each_model", center(SurfaceCenter::kBody)},
                   {"each_surface", center(SurfaceCenter::kSurface)}},
       .field = Surface<&SurfaceOptions::center>(),
       .orca = {{"center_of_surface_pattern"}}},
  };
  for (const auto& section : {Expansion, Bridges})
    for (SettingSpec& spec : section()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
