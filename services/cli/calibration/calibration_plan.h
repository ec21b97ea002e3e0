#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/calibration_table.h"
#include "common/model/scene/scene.h"
#include "common/model/setting.h"
#include "services/cli/calibration/calibration_kind.h"

namespace slicefarm::cli {

/// Object of a calibration print.
struct CalibrationPart {
  std::string name;
  std::string stl;  ///< content of a binary STL file, in mm
  std::vector<HeightRange> ranges;
  std::vector<Setting> settings;
  std::optional<Point> middle = {};  ///< position on the bed; empty: the part is arranged
};

/// Calibration print: objects, settings of the job, and the table of values.
struct CalibrationPlan {
  std::vector<CalibrationPart> parts;
  std::vector<Setting> settings;
  CalibrationTable table;
};

/// Returns the calibration print. `settings_text`: effective settings of the printer, process and
/// filament (ResolvedSettings::effective_text). `levels`: result of LevelsOf. `method`: only for
/// pressure advance. Errors: NOT_SUPPORTED for a firmware without the command;
/// SETTING_OUT_OF_RANGE for speeds beyond the machine's limit.
absl::StatusOr<CalibrationPlan> PlanCalibration(CalibrationKind kind,
                                                const std::vector<double>& levels,
                                                std::string_view settings_text,
                                                CalibrationMethod method = {});

/// Returns the number of a setting in `key = value` lines: the first number of its value, or
/// `otherwise` if it has none.
double NumberIn(std::string_view settings_text, std::string_view key, double otherwise);

/// Returns the text of a setting in `key = value` lines; empty if it is missing.
std::string_view TextIn(std::string_view settings_text, std::string_view key);

}  // namespace slicefarm::cli
