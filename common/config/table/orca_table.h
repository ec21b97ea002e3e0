#pragma once

#include <span>
#include <string_view>

#include "common/config/table/orca_name.h"

namespace slicefarm::config {

/// Conversion of a setting of OrcaSlicer to a setting of PrusaSlicer.
struct OrcaRow {
  std::string_view from;  ///< name in OrcaSlicer and Bambu Studio
  /// name in PrusaSlicer; if several rows have the same `to`, the last row is used
  std::string_view to;
  OrcaValue value = OrcaValue::kSame;
  std::string_view detail = {};
};

/// Conversion of one value of a choice setting from OrcaSlicer to PrusaSlicer. If PrusaSlicer has
/// no such value, `to` is empty and nothing is set.
struct OrcaChoice {
  /// OrcaRow::to of the row to which the conversion applies. OrcaRow::from would not be unique: one
  /// key of OrcaSlicer may decide two settings.
  std::string_view row;
  std::string_view from;
  std::string_view to;
  /// true: both values mean the same; false: they are only similar, and the difference is reported
  bool exact = true;
};

/// Variable that G-code may name and that is not a setting, in OrcaSlicer and in PrusaSlicer.
struct OrcaVariable {
  std::string_view from;
  std::string_view to;  ///< variable or setting in PrusaSlicer
};

/// OrcaSlicer's default value of a setting that G-code may name although no preset has it.
struct OrcaStandard {
  std::string_view key;
  std::string_view value;
};

/// Returns the conversions of settings: first the names from the settings table
/// (SettingSpec::orca), then settings without effect. This list and the three lists below are made
/// once.
std::span<const OrcaRow> OrcaRows();
/// Returns the conversions of choices.
std::span<const OrcaChoice> OrcaChoices();
/// Returns the variables of G-code.
std::span<const OrcaVariable> OrcaVariables();
/// Returns the default values.
std::span<const OrcaStandard> OrcaStandards();

}  // namespace slicefarm::config
