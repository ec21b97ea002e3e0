#pragma once

#include <string_view>

namespace slicefarm::config {

/// Conversion of a value from OrcaSlicer's form to PrusaSlicer's.
enum class OrcaValue {
  kSame,
  kPercent,    ///< a number is a percentage, with or without its sign
  kPercentOf,  ///< a percentage is one of `detail`, which is another setting of OrcaSlicer's
  kOrAuto,     ///< a number; a negative one, or `detail`, leaves the choice to the slicer
  kRest,       ///< a percentage; PrusaSlicer has its complement to 100%
  kNot,        ///< a flag that means the opposite
  kPoints,     ///< a list counts as a whole
  kPairs,      ///< the same, with `;` between its items
  kChoice,     ///< a name that OrcaChoices lists for the setting
  kWhole,      ///< the text as it is
  kGcode,      ///< G-code with other names of placeholders
};

/// Name of a setting in OrcaSlicer and Bambu Studio.
struct OrcaName {
  std::string_view name;
  OrcaValue value = OrcaValue::kSame;
  std::string_view detail = {};
};

}  // namespace slicefarm::config
