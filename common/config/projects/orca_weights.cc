#include "common/config/projects/orca_weights.h"

#include <algorithm>

#include "common/base/text.h"

namespace slicefarm::config {
namespace {

struct Weighty {
  std::string_view key;
  /// Values that request nothing, separated by `|`; an empty value never requests anything.
  std::string_view neutral;
};

constexpr Weighty kWeighty[] = {
    // Settings that change the material or sizes.
    {"hole_to_polyhole", "0"},
    {"make_overhang_printable", "0"},
    {"zaa_enabled", "0"},
    {"precise_z_height", "0"},
    {"interlocking_beam", "0"},
    // Settings that change walls and infill.
    {"alternate_extra_wall", "0"},
    {"extra_solid_infills", ""},
    {"fill_multiline", "1"},
    {"top_surface_density", "100%|100"},
    {"bottom_surface_density", "100%|100"},
    {"fuzzy_skin_first_layer", "0"},
    {"fuzzy_skin_noise_type", "classic"},
    {"skirt_type", "combined"},
    {"print_order", "default"},
    // Settings for temperatures, fans and the machine.
    {"resonance_avoidance", "0"},
    {"change_extrusion_role_gcode", ""},
    {"process_change_extrusion_role_gcode", ""},
    {"filament_change_extrusion_role_gcode", ""},
    {"timelapse_type", "0"},
    {"file_start_gcode", ""},
    {"post_process", ""},
};

/// Settings that only the windows and checks of OrcaSlicer read, and settings that it ignores.
constexpr std::string_view kOfProgram[] = {
    "adaptive_layer_height", "nozzle_temperature_range_high", "nozzle_temperature_range_low",
    "temperature_vitrification", "tree_support_adaptive_layer_height"};

/// Returns true if `value`, or each of its items if it is a list, requests nothing.
bool AllNeutral(std::string_view value, std::string_view neutral) {
  const std::vector<std::string_view> accepted = Split(neutral, "|");
  const std::vector<std::string_view> items = Split(value, "[]\", \n");
  return std::all_of(items.begin(), items.end(), [&](std::string_view item) {
    return item.empty() || std::find(accepted.begin(), accepted.end(), item) != accepted.end();
  });
}

}  // namespace

OrcaWeight WeightOf(std::string_view key, std::string_view value) {
  if (std::ranges::find(kOfProgram, key) != std::end(kOfProgram)) return OrcaWeight::kNothing;
  const auto* const found = std::find_if(std::begin(kWeighty), std::end(kWeighty),
                                         [&](const Weighty& each) { return each.key == key; });
  if (found == std::end(kWeighty)) return OrcaWeight::kDetail;
  return AllNeutral(value, found->neutral) ? OrcaWeight::kNothing : OrcaWeight::kPrint;
}

}  // namespace slicefarm::config
