#include "common/config/table/value.h"
#include "processes/fdm/settings/table/needs.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

/// Returns the speed of scarfs: mm/s, or a percentage of the wall's speed.
SettingSpec ScarfSpeed() {
  const auto set = [](RegionRow& row, const Value& value) {
    row.motion.scarf.speed_mm_s = value.percent ? 0 : value.number;
    row.motion.scarf.speed_ratio = value.percent && value.number > 0 ? value.number / 100 : 1;
  };
  const auto get = [](const RegionRow& row) -> Value {
    const ScarfOptions& scarf = row.motion.scarf;
    if (scarf.speed_mm_s != 0) return {.number = scarf.speed_mm_s};
    return {.number = Quantise(scarf.speed_ratio * 100), .percent = true};
  };
  return {.key = "scarf_seam_speed",
          .kind = Kind::kNumberOrPercent,
          .unit = "mm/s",
          .min = 1,
          .max = 10'000,
          .standard = "100%",
          .doc = "Highest speed of a scarf; 100%: the speed of the wall",
          .percent_of = "the speed of the wall",
          .field = Convert<RegionRow>(set, get),
          .orca = {{"scarf_joint_speed"}},
          .needs = {&needs::kScarfSeam}};
}

std::vector<SettingSpec> ScarfSettings() {
  const auto placement = [](ScarfPlacement place) { return static_cast<int>(place); };
  return {
      {.key = "scarf_seam_placement",
       .kind = Kind::kChoice,
       .standard = "nowhere",
       .doc = "Loops with a scarf seam: the loop begins low and thin, rises to the layer height "
              "and ends on top of its own beginning. The first layer has no scarfs. contours: "
              "outer contours. everywhere: outer contours and holes",
       .choices = {{"nowhere", placement(ScarfPlacement::kNowhere)},
                   {"contours", placement(ScarfPlacement::kContours)},
                   {"everywhere", placement(ScarfPlacement::kEverywhere)}},
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::placement>(),
       .orca = {{"seam_slope_type", OrcaValue::kChoice}}},
      {.key = "scarf_seam_only_on_smooth",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "Print no scarf where a corner hides the seam; 0: also at corners",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::only_on_smooth>(),
       .orca = {{"seam_slope_conditional"}}},
      {.key = "scarf_seam_smooth_angle",
       .unit = "degrees",
       .min = 0,
       .max = 180,
       .standard = "150",
       .doc = "Smallest angle between two edges of a loop at which scarf_seam_only_on_smooth does "
              "not take their common point for a corner; 180: only straight walls have scarfs",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::smooth_angle_deg>(),
       .orca = {{"scarf_angle_threshold"}},
       .needs = {&needs::kScarfSeam}},
      {.key = "scarf_seam_max_overhang",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "Unsupported share of a wall's width at the start of the wall, from which the wall "
              "has no scarf with scarf_seam_only_on_smooth = 1; 0%: all walls may have a scarf",
       .field = Bind<Scale::kPercent, &RegionRow::motion, &RegionMotion::scarf,
                     &ScarfOptions::most_overhang>(),
       .orca = {{"scarf_overhang_threshold", OrcaValue::kPercent}},
       .needs = {&needs::kScarfSeam}},
      {.key = "scarf_seam_start_height",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "Height at which a scarf begins, as a share of the layer height; 0%: at the top of "
              "the layer below",
       .field = Bind<Scale::kPercent, &RegionRow::motion, &RegionMotion::scarf,
                     &ScarfOptions::start_height_ratio>(),
       .orca = {{"seam_slope_start_height", OrcaValue::kShareOf, "layer_height"}}},
      {.key = "scarf_seam_entire_loop",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Extend the scarf over the whole loop; scarf_seam_length then has no effect",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::entire_loop>(),
       .orca = {{"seam_slope_entire_loop"}}},
      {.key = "scarf_seam_length",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Length of a scarf; at most the length of the loop",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::length_mm>(),
       .orca = {{"seam_slope_min_length"}}},
      {.key = "scarf_seam_max_segment_length",
       .unit = "mm",
       .min = 0.15,
       .max = 100,
       .standard = "1",
       .doc = "Longest piece of a scarf with constant height and flow; smaller: smoother",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::max_segment_mm>()},
      {.key = "scarf_seam_steps",
       .kind = Kind::kInteger,
       .min = 1,
       .max = 1000,
       .standard = "1",
       .doc = "Least number of pieces with constant height and flow in a scarf; larger: smoother",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::least_segments>(),
       .orca = {{"seam_slope_steps"}},
       .needs = {&needs::kScarfSeam}},
      ScarfSpeed(),
      {.key = "scarf_seam_flow_ratio",
       .min = 0.1,
       .max = 2,
       .standard = "1",
       .doc = "Factor for the flow of scarfs; 1: the flow that fills the height of the scarf",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::flow>(),
       .orca = {{"scarf_joint_flow_ratio"}},
       .needs = {&needs::kScarfSeam}},
      {.key = "scarf_seam_on_inner_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Print scarfs on inner walls too",
       .field = Bind<&RegionRow::motion, &RegionMotion::scarf, &ScarfOptions::on_inner>(),
       .orca = {{"seam_slope_inner_walls"}}},
  };
}

}  // namespace

std::vector<SettingSpec> SeamSettings() {
  const auto seam = [](SeamPosition position) { return static_cast<int>(position); };
  std::vector<SettingSpec> settings = {
      {.key = "seam_position",
       .kind = Kind::kChoice,
       .standard = "aligned",
       .doc = "Start point of loops, where the seam is. aligned: above each other, at corners. "
              "nearest: near the nozzle. rear: at the back of the object. random: anywhere. "
              "hidden: above each other, where the seam is least visible",
       .choices = {{"aligned", seam(SeamPosition::kAligned)},
                   {"nearest", seam(SeamPosition::kNearest)},
                   {"rear", seam(SeamPosition::kRear)},
                   {"random", seam(SeamPosition::kRandom)},
                   {"hidden", seam(SeamPosition::kHidden)}},
       .field = Bind<&ObjectRow::seam>(),
       .orca = {{"seam_position", OrcaValue::kChoice}}},
      {.key = "staggered_inner_seams",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Move the seam of each inner loop along the wall, farther for each loop inwards, so "
              "that seams are not side by side; 0: side by side",
       .field = Bind<&RegionRow::order, &WallOrder::stagger_seams>(),
       .orca = {{"staggered_inner_seams"}}},
  };
  SettingSpec gap{.key = "seam_gap_distance",
                  .kind = Kind::kNumberOrPercent,
                  .unit = "mm",
                  .min = 0,
                  .max = 10,
                  .standard = "0",
                  .doc =
                      "Gap between the end and the beginning of a loop, so that no blob forms "
                      "there; loops with a scarf have no gap. 0: no gap",
                  .relative_to = "nozzle_diameter",
                  .field = Bind<&MachineRow::motion, &MachineMotion::seam_gap_mm>(),
                  .orca = {{"seam_gap"}}};
  settings.push_back(gap);
  gap.key = "filament_seam_gap_distance";
  gap.list = List::kPerExtruder;
  gap.standard = kNotSet;
  gap.doc =
      "Value for this filament, which replaces the setting with the same name without the prefix "
      "`filament_`. nil: the setting without the prefix applies";
  gap.field = {};
  settings.push_back(gap);
  for (SettingSpec& scarf : ScarfSettings()) settings.push_back(std::move(scarf));
  return settings;
}

}  // namespace slicefarm::config::fdm
