#pragma once

#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/calibration_table.h"
#include "common/model/setting.h"

namespace slicefarm::cli {

/// Returns the value of the setting for a number in the unit of the labels, `text`. The number is
/// between the smallest and the largest label; between two labels the value is interpolated.
/// Errors: REQUEST_MALFORMED with the range of labels.
absl::StatusOr<double> ValueAt(const CalibrationTable& table, std::string_view text);

/// Returns the settings that get the value of ValueAt. Errors: also NOT_SUPPORTED if the firmware
/// keeps the value, or if the table is not from a calibration print.
absl::StatusOr<std::vector<Setting>> ChosenSettings(const CalibrationTable& table,
                                                    std::string_view text);

}  // namespace slicefarm::cli
