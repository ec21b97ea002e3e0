#include "processes/laser/settings/check_settings.h"

#include <fmt/core.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "common/base/error.h"
#include "common/config/setting_refusal.h"
#include "common/config/table/value.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm::config::laser {
namespace {

constexpr double kLeastHatchMm = 0.001;

/// Returns the keys of the given hatch distances; skins may have their own distances.
std::vector<std::string_view> HatchDistances(const SettingValues& draft) {
  std::vector<std::string_view> keys = {"hatch_distance"};
  for (const std::string_view key : {"upskin_distance", "downskin_distance"})
    if (draft.Number(key) > 0) keys.push_back(key);
  return keys;
}

/// Checks widths and overlaps. Stripes and islands must be wider than their overlaps, because
/// otherwise each one would not advance beyond the previous one.
absl::Status CheckScan(const SettingValues& draft) {
  const double overlap = draft.Number("scan_overlap");
  for (const std::string_view width : {"stripe_width", "island_width"}) {
    if (draft.Number(width) <= 2 * overlap)
      return Refuse(
          draft, width,
          fmt::format("it must be more than twice scan_overlap = {} mm", PrintNumber(overlap)),
          2 * overlap, kUnbounded);
    for (const std::string_view key : HatchDistances(draft))
      if (draft.Number(width) < draft.Number(key))
        return Refuse(
            draft, width,
            fmt::format("it must be at least {} = {} mm", key, PrintNumber(draft.Number(key))),
            draft.Number(key), kUnbounded);
  }
  for (const std::string_view key : HatchDistances(draft)) {
    if (draft.Number(key) < kLeastHatchMm)
      return Refuse(draft, key,
                    fmt::format("it must be 0 (hatch_distance applies) or at least {} mm",
                                PrintNumber(kLeastHatchMm)),
                    kLeastHatchMm, kUnbounded);
    if (draft.Number("ring_overlap") > draft.Number(key))
      return Refuse(
          draft, "ring_overlap",
          fmt::format("it must not exceed {} = {} mm", key, PrintNumber(draft.Number(key))), 0,
          draft.Number(key));
  }
  return absl::OkStatus();
}

/// Checks the angle window around the gas flow. Lines that run in both directions can use only half
/// the window of lines in one direction.
absl::Status CheckGas(const SettingValues& draft) {
  const bool islands = draft.Number("scan_strategy") == static_cast<double>(ScanStrategy::kIslands);
  const double window = draft.Number("gas_window"), widest = kWidestGasWindowDeg / 2;
  if (!islands || window <= widest) return absl::OkStatus();
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
      fmt::format("gas_window = {} degrees is out of range: with scan_strategy = islands, which "
                  "has lines in two directions, it must not exceed {} degrees",
                  PrintNumber(window), PrintNumber(widest)),
      {{"setting", "gas_window"}, {"value", PrintNumber(window)}, {"max", PrintNumber(widest)}});
}

/// Checks power values. G-code contains power as a fraction of the laser's full power.
absl::Status CheckPower(const SettingValues& draft) {
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

absl::Status CheckSettings(const SettingValues& draft) {
  absl::Status status = CheckScan(draft);
  status.Update(CheckGas(draft));
  status.Update(CheckPower(draft));
  return status;
}

}  // namespace slicefarm::config::laser
