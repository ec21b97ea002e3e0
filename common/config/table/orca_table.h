#pragma once

#include <span>
#include <string_view>

#include "common/config/table/orca_name.h"

namespace slicefarm::config {

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

/// Returns the names of all settings in OrcaSlicer: those that rows of the settings table tell, then
/// those of settings that slicefarm only knows. Made once.
std::span<const OrcaRow> OrcaRows();
std::span<const OrcaChoice> OrcaChoices();
std::span<const OrcaVariable> OrcaVariables();
std::span<const OrcaStandard> OrcaStandards();

}  // namespace slicefarm::config
