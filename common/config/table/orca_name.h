#pragma once

#include <string_view>

namespace slicefarm::config {

/// Conversion of a value from OrcaSlicer's form to PrusaSlicer's.
enum class OrcaValue {
  kSame,
  kPercent,    ///< number that is a percentage, with or without its sign
  kPercentOf,  ///< number; a percentage becomes this share of OrcaSlicer's setting `detail`
  kShareOf,    ///< percentage; a number becomes its percentage of OrcaSlicer's setting `detail`
  /// number; a negative number or the text `detail` means that the slicer chooses: then nothing is
  /// set
  kOrAuto,
  kRest,    ///< percentage that becomes its complement to 100 %
  kNot,     ///< flag with the opposite meaning
  kPoint,   ///< point, `x,y` or `XxY`
  kPoints,  ///< list of which all items are used, not only the first
  kPairs,   ///< list of which all items are used, with `;` between them
  kChoice,  ///< name of a choice, converted by OrcaChoices
  kWhole,   ///< unchanged text
  kGcode,   ///< G-code; its placeholders are renamed
};

/// Name of a setting in OrcaSlicer and Bambu Studio, and the conversion of its value.
struct OrcaName {
  std::string_view name;
  OrcaValue value = OrcaValue::kSame;
  std::string_view detail = {};
};

}  // namespace slicefarm::config
