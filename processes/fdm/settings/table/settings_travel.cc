#include <iterator>
#include <utility>

#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Adds a retraction setting, and the setting of the filament that overrides it (through derive.h).
void AddRetraction(std::vector<SettingSpec>& to, SettingSpec spec, std::string_view filament_key) {
  spec.list = List::kPerExtruder;
  to.push_back(spec);
  spec.key = filament_key;
  spec.standard = kNotSet;
  spec.doc = "The filament's own value of the setting without filament_; nil: none";
  spec.field = {};
  to.push_back(spec);
}

void AddRetraction(std::vector<SettingSpec>& to, std::string_view key,
                   std::string_view filament_key, std::string_view unit, double max,
                   std::string_view standard, std::string_view doc, Field field, double min = 0) {
  AddRetraction(to,
                {.key = key,
                 .unit = unit,
                 .min = min,
                 .max = max,
                 .standard = standard,
                 .doc = doc,
                 .field = field},
                filament_key);
}

std::vector<SettingSpec> Retraction() {
  std::vector<SettingSpec> settings;
  AddRetraction(settings, "retract_length", "filament_retract_length", "mm", 100, "2",
                "How much filament is pulled back before a travel; 0: none",
                Bind<&ToolRow::retraction, &RetractionOptions::length_mm>());
  AddRetraction(settings, "retract_speed", "filament_retract_speed", "mm/s", 1000, "40",
                "Speed of pulling back",
                Bind<&ToolRow::retraction, &RetractionOptions::speed_mm_s>());
  AddRetraction(settings, "deretract_speed", "filament_deretract_speed", "mm/s", 1000, "0",
                "Speed of pushing forward again; 0: retract_speed",
                Bind<&ToolRow::retraction, &RetractionOptions::restart_speed_mm_s>());
  AddRetraction(settings, "retract_restart_extra", "filament_retract_restart_extra", "mm", 100, "0",
                "How much more is pushed forward than was pulled back; negative: how much less",
                Bind<&ToolRow::retraction, &RetractionOptions::restart_extra_mm>(),
                /*min=*/-100);
  AddRetraction(settings, "retract_before_travel", "filament_retract_before_travel", "mm", 1000,
                "2", "Shorter travels do not retract, but for those over outer walls",
                Bind<&ToolRow::retraction, &RetractionOptions::min_travel_mm>());
  AddRetraction(settings, "retract_lift", "filament_retract_lift", "mm", 100, "0",
                "How far the nozzle rises over a travel",
                Bind<&ToolRow::retraction, &RetractionOptions::lift_mm>());
  AddRetraction(settings, "retract_lift_above", "filament_retract_lift_above", "mm", 10'000, "0",
                "The nozzle does not rise in layers lower than this",
                Bind<&ToolRow::retraction, &RetractionOptions::lift_above_mm>());
  AddRetraction(settings, "retract_lift_below", "filament_retract_lift_below", "mm", 10'000, "0",
                "Nor in layers higher than this; 0: however high",
                Bind<&ToolRow::retraction, &RetractionOptions::lift_below_mm>());
  const auto after = [](LiftAfter a) { return static_cast<int>(a); };
  AddRetraction(
      settings,
      {.key = "retract_lift_enforce",
       .kind = Kind::kChoice,
       .standard = "all",
       .doc = "After which beads the nozzle rises for a travel: all, those of tops and of "
              "ironing, those of the first layer, or of both",
       .choices = {{"all", after(LiftAfter::kAll)},
                   {"top", after(LiftAfter::kTop)},
                   {"bottom", after(LiftAfter::kBottom)},
                   {"top_and_bottom", after(LiftAfter::kTopAndBottom)}},
       .field = Bind<&ToolRow::retraction, &RetractionOptions::lift_after>(),
       .orca = {{"retract_lift_enforce", OrcaValue::kChoice}}},
      "filament_retract_lift_enforce");
  AddRetraction(settings,
                {.key = "travel_ramping_lift",
                 .kind = Kind::kFlag,
                 .standard = "0",
                 .doc = "The nozzle rises along its way by travel_max_lift and travel_slope, in "
                        "place of straight up by retract_lift",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::ramping>()},
                "filament_travel_ramping_lift");
  AddRetraction(settings, "travel_max_lift", "filament_travel_max_lift", "mm", 1000, "0",
                "How far the nozzle rises along its way; less on short ways",
                Bind<&ToolRow::retraction, &RetractionOptions::ramp_lift_mm>());
  AddRetraction(settings, "travel_slope", "filament_travel_slope", "degrees", 90, "0",
                "How steeply the nozzle rises along its way; 0 and 90: straight up",
                Bind<&ToolRow::retraction, &RetractionOptions::ramp_slope_deg>());
  AddRetraction(settings,
                {.key = "travel_lift_before_obstacle",
                 .kind = Kind::kFlag,
                 .standard = "0",
                 .doc = "Rises more steeply where the way meets an edge of the layer below before "
                        "the nozzle is up",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::before_obstacles>()},
                "filament_travel_lift_before_obstacle");
  AddRetraction(settings,
                {.key = "wipe",
                 .kind = Kind::kFlag,
                 .standard = "0",
                 .doc = "The nozzle wipes along what it has printed while the filament is pulled "
                        "back, which leaves smaller blobs",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::wipe>(),
                 .orca = {{"wipe"}}},
                "filament_wipe");
  AddRetraction(
      settings,
      {.key = "retract_layer_change",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Retracts at each change of layer, even where the way is hidden in the "
              "part; done in any case where copies are labelled, and where G-code of "
              "the settings stands between layers",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::retract_layer_change>(),
       .orca = {{"retract_when_changing_layer"}}},
      "filament_retract_layer_change");
  AddRetraction(
      settings,
      {.key = "retract_before_wipe",
       .kind = Kind::kPercent,
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "How much of retract_length is pulled back before the nozzle wipes",
       .field = Bind<Scale::kPercent, &ToolRow::retraction, &RetractionOptions::before_wipe>(),
       .orca = {{"retract_before_wipe"}}},
      "filament_retract_before_wipe");
  return settings;
}

/// Returns the maximum detour: mm, or a percentage of the straight travel.
SettingSpec MaxDetour() {
  const auto set = [](MachineRow& row, const Value& value) {
    row.order.travel.max_detour_mm = value.percent ? 0 : value.number;
    row.order.travel.max_detour_ratio = value.percent ? value.number / 100 : 0;
  };
  const auto get = [](const MachineRow& row) -> Value {
    const TravelOptions& travel = row.order.travel;
    if (travel.max_detour_ratio == 0) return {.number = travel.max_detour_mm};
    return {.number = Quantise(travel.max_detour_ratio * 100), .percent = true};
  };
  return {.key = "avoid_crossing_perimeters_max_detour",
          .kind = Kind::kNumberOrPercent,
          .unit = "mm",
          .min = 0,
          .max = 1000,
          .standard = "0",
          .doc = "Walls are crossed where the way round them is longer by more than this; 0: never",
          .percent_of = "the straight way",
          .field = Convert<MachineRow>(set, get),
          .orca = {{"max_travel_detour_distance"}}};
}

std::vector<SettingSpec> Travels() {
  return {
      {.key = "only_retract_when_crossing_perimeters",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc =
           "Does not retract before travels inside the part; before those to outer walls and to "
           "or over top surfaces all the same, which is why it may be 1 here and 0 in PrusaSlicer",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::hide>(),
       .orca = {{"reduce_infill_retraction"}}},
      {.key = "retract_inside_after",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "30",
       .doc = "Longer travels retract inside the part as well; 0: none does",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::longest_hidden_mm>()},
      {.key = "avoid_crossing_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Leads travels round outer walls, inside the part",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::avoid_crossing>(),
       .orca = {{"reduce_crossing_wall"}}},
      MaxDetour(),
      {.key = "avoid_crossing_curled_overhangs",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Leads travels round overhangs that are likely to have curled up",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::avoid_curled>()},
  };
}

}  // namespace

std::vector<SettingSpec> TravelSettings() {
  std::vector<SettingSpec> settings = Retraction();
  for (SettingSpec& spec : Travels()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
