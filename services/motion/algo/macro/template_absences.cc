#include "services/motion/algo/macro/template_absences.h"

#include <algorithm>
#include <iterator>

namespace slicefarm::motion {
namespace {

/// All that ProgramVariables adds to LayerVariables.
constexpr std::string_view kWholePrint[] = {
    "extruded_volume",
    "extruded_volume_total",
    "extruded_weight",
    "extruded_weight_total",
    "first_layer_print_max",
    "first_layer_print_min",
    "first_layer_print_size",
    "input_filename",
    "input_filename_base",
    "normal_print_time",
    "num_instances",
    "num_objects",
    "print_time",
    "silent_print_time",
    "total_cost",
    "total_layer_count",
    "total_weight",
    "total_wipe_tower_cost",
    "total_wipe_tower_filament",
    "used_filament",
};

constexpr std::string_view kClock[] = {"timestamp", "year",   "month", "day",
                                       "hour",      "minute", "second"};

template <size_t kCount>
bool Has(const std::string_view (&names)[kCount], std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

}  // namespace

std::string_view WhyAbsent(std::string_view variable) {
  if (Has(kWholePrint, variable)) {
    return "known only to start_gcode and end_gcode, for a layer is made apart from the others";
  }
  if (Has(kClock, variable)) {
    return "there is no clock, so that equal jobs have equal bytes";
  }
  return {};
}

}  // namespace slicefarm::motion
