#pragma once

#include <string_view>

namespace slicefarm::config {

/// Conversion of a value from OrcaSlicer's form to PrusaSlicer's.
enum class OrcaValue {
  kSame,
  kPercent,    ///< number that is a percentage, with or without its sign
  kPercentOf,  ///< percentage of `detail`, which is another setting of OrcaSlicer
  kShareOf,    ///< percentage of `detail`, or a number that becomes one
  kOrAuto,     ///< number; if it is negative or `detail`, the slicer chooses the value
  kRest,       ///< percentage; PrusaSlicer has its complement to 100%
  kNot,        ///< flag with the opposite meaning
  kPoints,     ///< list that is used as a whole
  kPairs,      ///< list that is used as a whole, with `;` between its items
  kChoice,     ///< name that OrcaChoices lists for the setting
  kWhole,      ///< unchanged text
  kGcode,      ///< G-code with other names of placeholders
};

/// Name of a setting in OrcaSlicer and Bambu Studio.
struct OrcaName {
  std::string_view name;
  OrcaValue value = OrcaValue::kSame;
  std::string_view detail = {};
};

}  // namespace slicefarm::config
