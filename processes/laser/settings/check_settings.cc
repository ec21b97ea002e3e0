#include "processes/laser/settings/check_settings.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>

#include "common/base/error.h"
#include "common/config/setting_refusal.h"
#include "common/config/value.h"
#include "common/model/options/exposure_options.h"

namespace slicefarm::config::laser {
namespace {

/// Stripes and islands that overlap by all of their width would not get on.
absl::Status CheckScan(const Draft& draft) {
  const double overlap = draft.Number("scan_overlap");
  const double hatch = draft.Number("hatch_distance");
  for (const std::string_view width : {"stripe_width", "island_width"}) {
    if (draft.Number(width) <= 2 * overlap)
      return Refuse(
          draft, width,
          fmt::format("it must be more than twice scan_overlap = {} mm", PrintNumber(overlap)),
          2 * overlap, kUnbounded);
    if (draft.Number(width) < hatch)
      return Refuse(draft, width,
                    fmt::format("it must be at least hatch_distance = {} mm", PrintNumber(hatch)),
                    hatch, kUnbounded);
  }
  if (draft.Number("ring_overlap") <= hatch) return absl::OkStatus();
  return Refuse(draft, "ring_overlap",
                fmt::format("it must not exceed hatch_distance = {} mm", PrintNumber(hatch)), 0,
                hatch);
}

/// G-code says power as a part of the laser's full power.
absl::Status CheckPower(const Draft& draft) {
  const auto format = static_cast<OutputFormat>(std::lround(draft.Number("output_format")));
  if (format != OutputFormat::kGrbl && format != OutputFormat::kMarlin) return absl::OkStatus();
  const double full = draft.Number("laser_full_power");
  for (const std::string_view key :
       {"contour_power", "hatch_power", "upskin_power", "downskin_power", "thin_wall_power"}) {
    if (draft.Number(key) <= full) continue;
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                     fmt::format("{} = {} W is out of range: it must not exceed laser_full_power = "
                                 "{} W",
                                 key, PrintNumber(draft.Number(key)), PrintNumber(full)),
                     {{"setting", std::string(key)},
                      {"value", PrintNumber(draft.Number(key))},
                      {"max", PrintNumber(full)}});
  }
  return absl::OkStatus();
}

}  // namespace

absl::Status CheckSettings(const Draft& draft) {
  absl::Status status = CheckScan(draft);
  status.Update(CheckPower(draft));
  return status;
}

}  // namespace slicefarm::config::laser
