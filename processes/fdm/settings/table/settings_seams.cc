#include "common/config/table/value.h"
#include "processes/fdm/settings/table/settings_sections.h"

namespace slicefarm::config::fdm {
namespace {

std::vector<SettingSpec> ScarfSettings() {
  const auto placement = [](ScarfPlacement place) { return static_cast<int>(place); };
  return {
      {.key = "scarf_seam_placement",
       .kind = Kind::kChoice,
       .standard = "nowhere",
       .doc = "Which loops get a scarf: they begin low and thin, rise to the layer's height, and "
              "end over their own beginning; not on the first layer",
       .choices = {{"nowhere", placement(ScarfPlacement::kNowhere)},
                   {"contours", placement(ScarfPlacement::kContours)},
                   {"everywhere", placement(ScarfPlacement::kEverywhere)}},
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::placement>(),
       .orca = {{"seam_slope_type", OrcaValue::kChoice}}},
      {.key = "scarf_seam_only_on_smooth",
       .kind = Kind::kFlag,
       .standard = "1",
       .doc = "No scarf where the seam is at a corner, which hides it",
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::only_on_smooth>(),
       .orca = {{"seam_slope_conditional"}}},
      {.key = "scarf_seam_start_height",
       .kind = Kind::kPercent,
       .unit = "%",
       .min = 0,
       .max = 100,
       .standard = "0%",
       .doc = "How high in its layer a scarf begins",
       .field = Bind<Scale::kPercent, &RegionRow::motion, &RegionSpeeds::scarf,
                     &ScarfOptions::start_height_ratio>()},
      {.key = "scarf_seam_entire_loop",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "The scarf is as long as the loop, whatever scarf_seam_length says",
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::entire_loop>(),
       .orca = {{"seam_slope_entire_loop"}}},
      {.key = "scarf_seam_length",
       .unit = "mm",
       .min = 0,
       .max = 1000,
       .standard = "20",
       .doc = "Length of a scarf; no longer than the loop",
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::length_mm>(),
       .orca = {{"seam_slope_min_length"}}},
      {.key = "scarf_seam_max_segment_length",
       .unit = "mm",
       .min = 0.15,
       .max = 100,
       .standard = "1",
       .doc = "Longest piece of a scarf: within one the flow is constant",
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::max_segment_mm>()},
      {.key = "scarf_seam_on_inner_perimeters",
       .kind = Kind::kFlag,
       .standard = "0",
       .doc = "Inner walls get scarfs too",
       .field = Bind<&RegionRow::motion, &RegionSpeeds::scarf, &ScarfOptions::on_inner>(),
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
       .doc = "Where loops start: in line up the object and at corners, near the nozzle, at the "
              "back, anywhere, or in line where the least is seen of it",
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
       .doc = "Each inner loop starts further along than the one outside of it, by as much as it "
              "lies inside of the outermost",
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
                      "How much of a loop stays open at its end, so that no blob lies on its "
                      "beginning; scarfs close",
                  .relative_to = "nozzle_diameter",
                  .field = Bind<&MachineRow::motion, &MachineMotion::seam_gap_mm>(),
                  .orca = {{"seam_gap"}}};
  settings.push_back(gap);
  gap.key = "filament_seam_gap_distance";
  gap.list = List::kPerExtruder;
  gap.standard = kNotSet;
  gap.doc = "The filament's own value of the setting without filament_; nil: none";
  gap.field = {};
  settings.push_back(gap);
  for (SettingSpec& scarf : ScarfSettings()) settings.push_back(std::move(scarf));
  return settings;
}

}  // namespace slicefarm::config::fdm
