#include "common/config/projects/orca_legacy.h"

#include <string_view>

namespace slicefarm::config {
namespace {

struct Renamed {
  std::string_view from, to;
};

constexpr Renamed kKeys[] = {{"bridge_fan_speed", "overhang_fan_speed"},
                             {"chamber_temperatures", "chamber_temperature"},
                             {"cooling", "slow_down_for_layer_cooling"},
                             {"counterbole_hole_bridging", "counterbore_hole_bridging"},
                             {"initial_layer_flow_ratio", "bottom_solid_infill_flow_ratio"},
                             {"ironing_direction", "ironing_angle"},
                             {"sparse_infill_anchor", "infill_anchor"},
                             {"sparse_infill_anchor_max", "infill_anchor_max"},
                             {"support_material_angle", "support_angle"},
                             {"support_material_enforce_layers", "enforce_support_layers"},
                             {"thumbnail_size", "thumbnails"},
                             {"tool_change_gcode", "change_filament_gcode"},
                             {"wall_infill_order", "wall_sequence"},
                             {"wiping_volume", "prime_volume"}};

/// New value of a key with its new name.
struct NewValue {
  std::string_view key, from, to;
};

constexpr NewValue kValues[] = {
    {"draft_shield", "limited", "disabled"},
    {"ensure_vertical_shell_thickness", "0", "ensure_moderate"},
    {"ensure_vertical_shell_thickness", "1", "ensure_all"},
    {"support_base_pattern", "none", "hollow"},
    {"support_type", "hybrid(auto)", "tree(auto)"},
    {"support_type", "normal", "normal(manual)"},
    {"support_type", "tree", "tree(manual)"},
    {"timelapse_type", "2", "0"},
    {"wall_sequence", "infill/inner wall/outer wall", "inner wall/outer wall"},
    {"wall_sequence", "infill/outer wall/inner wall", "outer wall/inner wall"},
    {"wall_sequence", "inner wall/outer wall/infill", "inner wall/outer wall"},
    {"wall_sequence", "inner-outer-inner wall/infill", "inner-outer-inner wall"},
    {"wall_sequence", "outer wall/inner wall/infill", "outer wall/inner wall"}};

}  // namespace

Setting Modernized(Setting setting) {
  for (const Renamed& key : kKeys)
    if (setting.key == key.from) setting.key = key.to;
  for (const NewValue& value : kValues) {
    if (setting.key != value.key || setting.value != value.from) continue;
    setting.value = value.to;
    break;
  }
  return setting;
}

}  // namespace slicefarm::config
