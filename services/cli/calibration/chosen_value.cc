#include "services/cli/calibration/chosen_value.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "common/base/error.h"
#include "common/base/text.h"
#include "services/cli/calibration/calibration_kind.h"
#include "services/cli/job/job_options.h"

namespace slicefarm::cli {
namespace {

absl::Status Refuse(const std::string& message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNotSupported, message);
}

}  // namespace

absl::StatusOr<double> ValueAt(const CalibrationTable& table, std::string_view text) {
  std::vector<std::pair<double, double>> values;  // label, value
  for (const CalibrationRow& row : table.rows)
    if (const auto label = ToNumber(row.label)) values.emplace_back(*label, row.value);
  std::ranges::sort(values);
  if (values.empty()) return Malformed("the table of the calibration print has no values");
  const std::optional<double> at = ToNumber(text);
  if (!at || *at < values.front().first || *at > values.back().first)
    return Malformed(fmt::format("{}: is not a value of this print, which has {:g} to {:g} {}",
                                 text, values.front().first, values.back().first, table.unit));
  const auto above = std::ranges::lower_bound(values, *at, {}, &std::pair<double, double>::first);
  if (above->first == *at) return above->second;
  const auto below = std::prev(above);
  const double share = (*at - below->first) / (above->first - below->first);
  return below->second + share * (above->second - below->second);
}

absl::StatusOr<std::vector<Setting>> ChosenSettings(const CalibrationTable& table,
                                                    std::string_view text) {
  const CalibrationInfo* info = CalibrationNamed(table.kind);
  if (info == nullptr) return Refuse("the job is no calibration print");
  if (table.setting.empty())
    return Refuse(
        fmt::format("{}: no setting of slicefarm has this value; write it into the "
                    "configuration of the printer's firmware",
                    table.kind));
  const auto value = ValueAt(table, text);
  if (!value.ok()) return value.status();
  std::vector<Setting> settings = {
      {table.setting, fmt::format("{:.6g}", *value), Source::kRequest}};
  if (!info->other.empty())
    settings.push_back({std::string(info->other), settings.front().value, Source::kRequest});
  return settings;
}

}  // namespace slicefarm::cli
