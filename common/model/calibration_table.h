#pragma once

#include <string>
#include <vector>

namespace slicefarm {

/// Place of a value in a calibration print: heights of a tower, or an object.
struct CalibrationRow {
  std::string label;   ///< text on the print, in CalibrationTable::unit
  double value = 0;    ///< value of CalibrationTable::setting
  double from_mm = 0;  ///< heights above the bed; 0 and 0: the whole object
  double to_mm = 0;
  std::string object;  ///< name of the object

  friend bool operator==(const CalibrationRow&, const CalibrationRow&) = default;
};

/// Values that a calibration print compares.
struct CalibrationTable {
  std::string kind;  ///< kind of the print, such as `pressure-advance`; empty: no calibration print
  std::string unit;
  std::string setting;  ///< setting that gets the chosen value; empty: the firmware keeps it
  std::vector<CalibrationRow> rows;

  friend bool operator==(const CalibrationTable&, const CalibrationTable&) = default;
};

}  // namespace slicefarm
