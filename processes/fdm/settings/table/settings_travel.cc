#include <iterator>
#include <utility>

#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Adds a retraction setting, and the setting of the filament that overrides it (through derive.h).
void AddRetraction(std::vector<SettingSpec>& to, SettingSpec spec, std::string_view filament_key) {
  spec.list = List::kPerExtruder;
  to.push_back(spec);
  spec.key = filament_key;
  spec.standard = kNotSet;
  spec.doc =
      "Value for this filament, which replaces the setting with the same name without the prefix "
      "`filament_`. nil: the setting without the prefix applies";
  spec.field = {};
  to.push_back(spec);
}

void AddRetraction(std::vector<SettingSpec>& to, std::string_view key,
                   std::string_view filament_key, std::string_view unit, double max,
                   std::string_view standard, std::string_view doc, Field field,
                   std::vector<const Need*> needs = {}, double min = 0) {
  AddRetraction(to,
                {.key = key,
                 .unit = unit,
                 .min = min,
                 .max = max,
                 .standard = standard,
                 .doc = doc,
                 .field = field,
                 .needs = std::move(needs)},
                filament_key);
}

std::vector<SettingSpec> Retraction() {
  std::vector<SettingSpec> settings;
  AddRetraction(settings, "retract_length", "filament_retract_length", "mm", 100, "2",
                "Length of filament that is retracted before a travel; 0: no retraction",
                Bind<&ToolRow::retraction, &RetractionOptions::length_mm>());
  AddRetraction(settings, "retract_speed", "filament_retract_speed", "mm/s", 1000, "40",
                "Speed at which the filament is pulled back by retractions",
                Bind<&ToolRow::retraction, &RetractionOptions::speed_mm_s>(),
                {&needs::kRetractLength});
  AddRetraction(
      settings, "deretract_speed", "filament_deretract_speed", "mm/s", 1000, "0",
      "Speed at which the filament is pushed forward after a retraction; 0: retract_speed",
      Bind<&ToolRow::retraction, &RetractionOptions::restart_speed_mm_s>(),
      {&needs::kRetractLength});
  AddRetraction(settings, "retract_restart_extra", "filament_retract_restart_extra", "mm", 100, "0",
                "Additional length of filament that is pushed forward after a retraction; "
                "negative: less filament than was retracted",
                Bind<&ToolRow::retraction, &RetractionOptions::restart_extra_mm>(),
                {&needs::kRetractLength, &needs::kOwnRetraction}, /*min=*/-100);
  AddRetraction(
      settings, "retract_before_travel", "filament_retract_before_travel", "mm", 1000, "2",
      "Length of the shortest travel with a retraction; travels across outer walls always have a "
      "retraction",
      Bind<&ToolRow::retraction, &RetractionOptions::min_travel_mm>(), {&needs::kRetractLength});
  AddRetraction(settings, "retract_lift", "filament_retract_lift", "mm", 100, "0",
                "Height by which the nozzle is lifted for a travel (Z hop); 0: no lift",
                Bind<&ToolRow::retraction, &RetractionOptions::lift_mm>(),
                {&needs::kRetractLength, &needs::kStraightLift});
  AddRetraction(
      settings, "retract_lift_above", "filament_retract_lift_above", "mm", 10'000, "0",
      "Height above the bed from which the nozzle is lifted for travels; 0: at all heights",
      Bind<&ToolRow::retraction, &RetractionOptions::lift_above_mm>(), {&needs::kAnyLift});
  AddRetraction(
      settings, "retract_lift_below", "filament_retract_lift_below", "mm", 10'000, "0",
      "Height above the bed up to which the nozzle is lifted for travels; 0: no upper limit",
      Bind<&ToolRow::retraction, &RetractionOptions::lift_below_mm>(), {&needs::kAnyLift});
  const auto after = [](LiftAfter a) { return static_cast<int>(a); };
  AddRetraction(settings,
                {.key = "retract_lift_enforce",
                 .kind = Kind::kChoice,
                 .standard = "all",
                 .doc = "Lines after which the nozzle is lifted for a travel. all: all lines. top: "
                        "top surfaces and ironing. bottom: the first layer. top_and_bottom: top "
                        "surfaces, ironing and the first layer",
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
                 .doc = "Lift the nozzle gradually along the travel, with the slope travel_slope "
                        "up to travel_max_lift; 0: straight up by retract_lift",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::ramping>()},
                "filament_travel_ramping_lift");
  AddRetraction(settings, "travel_max_lift", "filament_travel_max_lift", "mm", 1000, "0",
                "Largest height by which the nozzle rises along a travel with travel_ramping_lift; "
                "short travels rise less, because travel_slope limits the rise. 0: no lift",
                Bind<&ToolRow::retraction, &RetractionOptions::ramp_lift_mm>(),
                {&needs::kRampingLift});
  AddRetraction(settings, "travel_slope", "filament_travel_slope", "degrees", 90, "0",
                "Slope, measured from horizontal, at which the nozzle rises along a travel with "
                "travel_ramping_lift; 0 and 90: straight up",
                Bind<&ToolRow::retraction, &RetractionOptions::ramp_slope_deg>(),
                {&needs::kRampingLift});
  AddRetraction(
      settings,
      {.key = "travel_lift_before_obstacle",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Lift the nozzle more steeply than travel_slope where the travel would otherwise "
              "cross an edge of the layer below before the nozzle is high enough",
       .field = Bind<&ToolRow::retraction, &RetractionOptions::before_obstacles>(),
       .needs = {&needs::kRampingLift}},
      "filament_travel_lift_before_obstacle");
  AddRetraction(settings,
                {.key = "wipe",
                 .kind = Kind::kFlag,
                 .standard = "0",
                 .doc = "Move the nozzle along the printed line while the filament is retracted, "
                        "which leaves smaller blobs; 0: retract on the spot",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::wipe>(),
                 .orca = {{"wipe"}},
                 .needs = {&needs::kRetractLength}},
                "filament_wipe");
  AddRetraction(
      settings,
      {.key = "retract_layer_change",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Retract at each layer change, even if the travel is inside the part. Labelled "
              "objects and custom G-code between layers always cause a retraction",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::retract_layer_change>(),
       .orca = {{"retract_when_changing_layer"}},
       .needs = {&needs::kHiddenTravels}},
      "filament_retract_layer_change");
  AddRetraction(
      settings,
      {.key = "retract_before_wipe",
       .kind = Kind::kPercent,
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "Share of retract_length that is retracted before the move of `wipe` begins; the "
              "rest is retracted during this move. 0%: all of it",
       .field = Bind<Scale::kPercent, &ToolRow::retraction, &RetractionOptions::before_wipe>(),
       .orca = {{"retract_before_wipe"}},
       .needs = {&needs::kWipe}},
      "filament_retract_before_wipe");
  AddRetraction(
      settings,
      {.key = "retract_after_wipe",
       .kind = Kind::kPercent,
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "Share of retract_length that is retracted after the wipe, at most the rest that "
              "retract_before_wipe leaves",
       .field = Bind<Scale::kPercent, &ToolRow::retraction, &RetractionOptions::after_wipe>(),
       .orca = {{"retract_after_wipe"}},
       .needs = {&needs::kWipe}},
      "filament_retract_after_wipe");
  AddRetraction(
      settings,
      {.key = "travel_spiral_lift",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Lift the nozzle on a circle before the travel, as steeply as travel_slope says, "
              "instead of along the travel",
       .field = Bind<&ToolRow::retraction, &RetractionOptions::spiral>(),
       .needs = {&needs::kRampingLift}},
      "filament_travel_spiral_lift");
  AddRetraction(settings,
                {.key = "wipe_distance",
                 .unit = "mm",
                 .min = 0,
                 .max = 100,
                 .standard = "0",
                 .doc = "Length of the move that `wipe` adds. If the retraction takes longer than "
                        "this move, the first part of the retraction is done before the move. 0: "
                        "as long as the retraction takes",
                 .field = Bind<&ToolRow::retraction, &RetractionOptions::wipe_distance_mm>(),
                 .needs = {&needs::kWipe}},
                "filament_wipe_distance");
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
          .doc =
              "Longest detour of a travel with avoid_crossing_perimeters; a travel that needs a "
              "longer detour crosses the wall. 0: no limit",
          .percent_of = "the straight travel",
          .field = Convert<MachineRow>(set, get),
          .orca = {{"max_travel_detour_distance"}},
          .needs = {&needs::kAvoidCrossing}};
}

/// Returns the shift of wipes: mm, or a percentage of the wall's width.
SettingSpec WipeInwardDistance() {
  const auto set = [](RegionRow& row, const Value& value) {
    row.motion.wipe_inward_nm = value.percent ? 0 : FromMm(value.number);
    row.motion.wipe_inward_share = value.percent ? value.number / 100 : 0;
  };
  const auto get = [](const RegionRow& row) -> Value {
    const RegionMotion& motion = row.motion;
    if (motion.wipe_inward_nm != 0)
      return {.number = Quantise(ToMm(static_cast<double>(motion.wipe_inward_nm)))};
    return {.number = Quantise(motion.wipe_inward_share * 100),
            .percent = motion.wipe_inward_share != 0};
  };
  return {.key = "wipe_inward_distance",
          .kind = Kind::kNumberOrPercent,
          .unit = "mm",
          .min = 0,
          .max = 100,
          .standard = "50%",
          .doc = "Distance by which wipe_inward shifts the wipe, at most the width of the wall",
          .percent_of = "the width of the wall",
          .field = Convert<RegionRow>(set, get),
          .own_scope = Scope::kJob,
          .orca = {{"wipe_inward_distance"}},
          .needs = {&needs::kWipe}};
}

std::vector<SettingSpec> Travels() {
  return {
      {.key = "only_retract_when_crossing_perimeters",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Do not retract before travels inside the part, where strings are not visible. "
              "Travels to outer walls and over top surfaces still retract. 0: all travels longer "
              "than retract_before_travel retract. Default in PrusaSlicer: 0",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::hide>(),
       .orca = {{"reduce_infill_retraction"}}},
      {.key = "retract_inside_after",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "30",
       .doc = "Length of the shortest travel inside the part that retracts in spite of "
              "only_retract_when_crossing_perimeters; 0: no travel inside the part retracts",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::longest_hidden_mm>(),
       .needs = {&needs::kHiddenTravels}},
      {.key = "avoid_crossing_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Plan travels inside the part so that they do not cross outer walls, which leaves "
              "fewer strings; 0: straight travels",
       .field = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::avoid_crossing>(),
       .orca = {{"reduce_crossing_wall"}}},
      {.key = "print_order",
       .kind = Kind::kChoice,
       .standard = "default",
       .doc =
           "Order of the copies in a layer. default: short travels. as_obj_list: the order of the "
           "objects on the plate",
       .choices = {{"default", 0}, {"as_obj_list", 1}},
       .field = Bind<&MachineRow::order, &JobOrder::as_listed>(),
       .orca = {{"print_order", OrcaValue::kChoice}}},
      MaxDetour(),
      {.key = "wipe_speed",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 1,
       .max = 1000,
       .standard = "80%",
       .doc = "Speed of the move that `wipe` adds, as a percentage of travel_speed",
       .field = Bind<Scale::kPercent, &MachineRow::motion, &MachineMotion::wipe_speed_ratio>(),
       .orca = {{"wipe_speed", OrcaValue::kShareOf, "travel_speed"}},
       .needs = {&needs::kWipe, &needs::kOwnWipeSpeed}},
      {.key = "role_based_wipe_speed",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Do the move of `wipe` at the speed of the line before it, but at least at 10 mm/s; "
              "0: at wipe_speed",
       .field = Bind<&MachineRow::motion, &MachineMotion::wipe_as_printed>(),
       .orca = {{"role_based_wipe_speed"}},
       .needs = {&needs::kWipe}},
      {.key = "wipe_on_loops",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Move inwards to the edge of the line at the end of each outer wall, before the "
              "travel, so that the seam is less visible; not on loops with a scarf",
       .field = Bind<&RegionRow::motion, &RegionMotion::wipe_on_loops>(),
       .orca = {{"wipe_on_loops"}}},
      {.key = "wipe_inward",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Shift the wipes of outer walls inwards, over the inner wall that was printed just "
              "before; walls without such an inner wall keep their wipe",
       .field = Bind<&RegionRow::motion, &RegionMotion::wipe_inward>(),
       .own_scope = Scope::kJob,
       .orca = {{"wipe_inward"}},
       .needs = {&needs::kWipe}},
      WipeInwardDistance(),
      {.key = "wipe_before_external_loop",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "End travels to outer walls at the inner edge of the line. The filament that is "
              "pushed forward after the retraction then does not thicken the start of the wall",
       .field = Bind<&RegionRow::motion, &RegionMotion::wipe_before_outer>(),
       .orca = {{"wipe_before_external_loop"}}},
      {.key = "avoid_crossing_curled_overhangs",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Plan travels around overhangs that have probably curled up, so that the nozzle does "
              "not hit them; 0: straight across",
       .field = Bind<&MachineRow::plan, &JobPlanOptions::avoid_curled>(),
       .also = Bind<&MachineRow::order, &JobOrder::travel, &TravelOptions::avoid_curled>()},
  };
}

}  // namespace

std::vector<SettingSpec> TravelSettings() {
  std::vector<SettingSpec> settings = Retraction();
  for (SettingSpec& spec : Travels()) settings.push_back(std::move(spec));
  return settings;
}

}  // namespace slicefarm::config::fdm
