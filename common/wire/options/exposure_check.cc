#include <algorithm>
#include <string_view>

#include "common/wire/options/options_check.h"
#include "common/wire/options/value_checks.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm {
namespace {

/// Smallest line distance. Finer lines are meaningless and would need too much memory.
constexpr Coord kLeastHatchNm = 1'000;
constexpr int32_t kMostCount = 1'000;  ///< largest number of contours and of layers in skins

absl::Status CheckStyle(const ExposureStyle& style) {
  absl::Status status = CheckNotNegative({{"styles.point_distance_nm", style.point_distance_nm}});
  for (const double value :
       {style.power_w, style.frequency_khz, style.point_time_us, style.point_delay_us})
    status.Update(CheckNoLessThanZero("styles: an amount", value));
  status.Update(CheckAboveZero("styles.speed_mm_s", style.speed_mm_s));
  return status;
}

absl::Status CheckJump(const JumpOptions& jump) {
  absl::Status status = CheckAboveZero("jump.speed_mm_s", jump.speed_mm_s);
  for (const double delay : {jump.delay_us, jump.mark_delay_us, jump.polygon_delay_us})
    status.Update(CheckNoLessThanZero("jump: a delay", delay));
  return status;
}

absl::Status CheckDistances(const ExposureOptions& region) {
  absl::Status status = CheckLengths({{"hatch_distance_nm", region.hatch_distance_nm},
                                      {"contour_distance_nm", region.contour_distance_nm}},
                                     kLeastHatchNm);
  for (const Coord distance : {region.upskin_distance_nm, region.downskin_distance_nm})
    if (distance != 0 && distance < kLeastHatchNm)
      status.Update(Malformed("upskin_distance_nm, downskin_distance_nm", "too small"));
  const Coord narrowest = std::min(region.stripe_width_nm, region.island_width_nm);
  if (narrowest <
      std::max({region.hatch_distance_nm, region.upskin_distance_nm, region.downskin_distance_nm}))
    status.Update(Malformed("stripe_width_nm, island_width_nm", "less than the hatch distance"));
  // Cells that overlap the next cell but one would be scanned three times.
  if (region.overlap_nm > narrowest / 2)
    status.Update(Malformed("overlap_nm", "more than half of a stripe or island"));
  if (region.ring_overlap_nm > region.hatch_distance_nm)
    status.Update(Malformed("ring_overlap_nm", "more than the hatch distance"));
  return status;
}

absl::Status CheckRegion(const ExposureOptions& region) {
  absl::Status status = CheckPositive({{"stripe_width_nm", region.stripe_width_nm},
                                       {"island_width_nm", region.island_width_nm},
                                       {"spot_nm", region.spot_nm}});
  status.Update(CheckNotNegative({{"minimum_vector_nm", region.minimum_vector_nm},
                                  {"overlap_nm", region.overlap_nm},
                                  {"ring_overlap_nm", region.ring_overlap_nm},
                                  {"beam_compensation_nm", region.beam_compensation_nm},
                                  {"hatch_offset_nm", region.hatch_offset_nm},
                                  {"skin_overlap_nm", region.skin_overlap_nm},
                                  {"skywriting_nm", region.skywriting_nm},
                                  {"contour_run_nm", region.contour_run_nm}}));
  status.Update(CheckDistances(region));
  const bool both_ways = region.strategy == ScanStrategy::kIslands;
  status.Update(CheckRange("gas_window_deg", region.gas_window_deg, 0,
                           both_ways ? kWidestGasWindowDeg / 2 : kWidestGasWindowDeg));
  for (const int32_t count : {region.contours, region.upskin_layers, region.downskin_layers,
                              region.z_compensation_layers})
    status.Update(CheckRange("contours or skin layers", count, 0, kMostCount));
  for (const ExposureStyle& style : region.styles) status.Update(CheckStyle(style));
  status.Update(CheckJump(region.jump));
  return status;
}

absl::Status CheckOutput(const ExposureOutput& output) {
  absl::Status status = CheckAboveZero("output.unit_mm", output.unit_mm);
  status.Update(CheckAboveZero("output.full_power_w", output.full_power_w));
  status.Update(CheckAboveZero("output.full_power_s", output.full_power_s));
  status.Update(CheckNoLessThanZero("output.layer", output.layer));
  status.Update(CheckNoLessThanZero("output.recoat_s", output.recoat_s));
  return status;
}

}  // namespace

absl::Status CheckOptions(const ExposureSettings& settings) {
  absl::Status status = CheckEach(settings.regions, "regions", CheckRegion);
  status.Update(CheckOutput(settings.output));
  return status;
}

}  // namespace slicefarm
