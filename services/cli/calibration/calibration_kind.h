#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::cli {

/// Quantity that a calibration print varies.
enum class CalibrationKind {
  kTemperature,
  kFlow,
  kPressureAdvance,
  kVolumetricSpeed,
  kRetraction,
  kVfa,
  kCornering,
  kInputShaping,
};

/// Form of the test print, if its kind has several.
enum class CalibrationMethod {
  kTower,    ///< a value for each floor
  kLine,     ///< a line for each value, with changes of speed
  kPattern,  ///< lines with corners for each value
};

/// Constants of a kind.
struct CalibrationInfo {
  CalibrationKind kind;
  std::string_view name;
  std::string_view doc;
  std::string_view unit;
  // Default values, and the range that is accepted. A temperature's defaults are relative to the
  // filament's temperature.
  double start, end, step;
  double min, max;
  int decimals;              ///< digits of the labels after the point
  std::string_view setting;  ///< setting that gets the chosen value; empty: the firmware keeps it
  std::string_view other;    ///< second setting that gets the value; empty: none
  bool of_filament;          ///< true if the value also depends on the filament
};

/// Returns all kinds, in the order of the help.
std::span<const CalibrationInfo> CalibrationInfos();
/// Returns the constants of a kind.
const CalibrationInfo& InfoOfCalibration(CalibrationKind kind);
/// Returns the constants of the kind with this name, or nullptr.
const CalibrationInfo* CalibrationNamed(std::string_view name);

/// Range of values as given on the command line.
struct GivenLevels {
  std::optional<double> start, end, step;
};

/// Maximum number of values in one print.
inline constexpr int kMostLevels = 60;

/// Returns the values of a print, from `start` in steps towards `end`. `base`: value to which the
/// defaults are added. Errors: REQUEST_MALFORMED for a step that is not above 0, values outside the
/// kind's range, fewer than 2 or more than kMostLevels values.
absl::StatusOr<std::vector<double>> LevelsOf(const CalibrationInfo& info, const GivenLevels& given,
                                             double base);

/// Returns the label of a value, with the kind's number of decimals. Labels of flow have a sign.
std::string LabelOf(const CalibrationInfo& info, double value);

/// Returns the G-code that sets the value of a kind in a firmware. `flavor`: setting gcode_flavor.
/// Errors: NOT_SUPPORTED if the firmware has no such command, or the kind is not set by G-code.
absl::StatusOr<std::string> CodeOf(const CalibrationInfo& info, std::string_view flavor,
                                   double value);

}  // namespace slicefarm::cli
