#pragma once

#include <span>
#include <string_view>

namespace slicefarm::config {

/// How a value of OrcaSlicer's becomes one of PrusaSlicer's.
enum class OrcaValue {
  kSame,
  kPercent,    ///< a number is a percentage, with or without its sign
  kPercentOf,  ///< a percentage is one of `detail`, which is another setting of OrcaSlicer's
  kOrAuto,     ///< a number; a negative one, or `detail`, leaves the choice to the slicer
  kRest,       ///< a percentage, of which PrusaSlicer says what is missing to 100%
  kNot,        ///< a flag that means the opposite
  kPoints,     ///< a list counts as a whole
  kPairs,      ///< the same, with `;` between its items
  kChoice,     ///< one of those that OrcaChoices lists for the row's `from`
  kWhole,      ///< the text as it is
  kGcode,      ///< G-code, whose placeholders have other names
};

struct OrcaRow {
  std::string_view from;  ///< OrcaSlicer's and Bambu Studio's name
  std::string_view to;    ///< PrusaSlicer's; two rows may have the same: the later one wins
  OrcaValue value = OrcaValue::kSame;
  std::string_view detail = {};
};

/// A value of a choice. Where PrusaSlicer has none, `to` is empty and there is nothing to set.
struct OrcaChoice {
  std::string_view row;  ///< OrcaRow::to, as one key may decide on two settings
  std::string_view from;
  std::string_view to;
  bool exact = true;  ///< else it is not quite the same, and is reported
};

/// What G-code may name besides settings.
struct OrcaVariable {
  std::string_view from;
  std::string_view to;  ///< PrusaSlicer's variable or setting
};

/// The value of a setting that G-code names and that a preset may leave out.
struct OrcaStandard {
  std::string_view key;
  std::string_view value;
};

std::span<const OrcaRow> OrcaRows();
std::span<const OrcaChoice> OrcaChoices();
std::span<const OrcaVariable> OrcaVariables();
std::span<const OrcaStandard> OrcaStandards();

}  // namespace slicefarm::config
