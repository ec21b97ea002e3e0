#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/config/reported_settings.h"
#include "common/config/setting_note.h"
#include "common/model/options/settings.h"
#include "common/model/setting.h"

namespace slicefarm::config {

using slicefarm::Setting;
using slicefarm::Source;

class ParsedTexts;

/// Factors by which parts are enlarged before slicing, because their filament shrinks when it
/// cools.
struct ShrinkageCompensation {
  double xy = 1;
  double z = 1;
};

/// Result of Resolve: the settings, their text, and notes for the report.
struct ResolvedSettings {
  JobRows settings;
  ShrinkageCompensation shrinkage;
  /// Text of the settings (EffectiveText), including given settings that no stage uses
  /// (reported_settings.h). Resolve of these lines gives the same `settings` and the same text.
  std::string effective_text;
  /// Given settings without effect or without full effect.
  std::vector<SettingNote> no_effect;
  /// Number of the last entries of no_effect that do not influence the print: values of other
  /// extruders and modes.
  int64_t beside_print = 0;
  /// Entries of no_effect that change the print, and other warnings.
  std::vector<std::string> warnings;
  std::vector<MissingFeature> missing;
};

/// Converts settings from text to the settings of a job: complete, in range, and with percentages
/// resolved. Later settings override earlier ones, even if the earlier ones are invalid. Settings
/// that are not given have the default of settings_table.h.
///
/// Errors:
/// - REQUEST_TOO_LARGE beyond the limits, also for the settings that the G-code of layers refers
///   to;
/// - SETTING_UNKNOWN for a kRequest key that neither slicefarm nor PrusaSlicer has (metadata
///   `setting` and, if there is a similar name, `suggestion`);
/// - SETTING_OF_OTHER_PROCESS for a kRequest key of another process (metadata `setting`,
///   `process`);
/// - SETTING_MALFORMED;
/// - SETTING_OUT_OF_RANGE (metadata `setting`, `value`, `min`, `max`), also for settings that are
///   inconsistent with each other.
absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process);
/// Resolves one of many sets of settings that share long texts. `parsed`: texts that earlier calls
/// have parsed; new long texts are added.
absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process,
                                         ParsedTexts& parsed);

/// Returns the settings that have an effect on the job's process as `key = value` lines, sorted by
/// key. The lines include `reported`: given settings that no stage uses. Two texts are equal if and
/// only if the settings are equal.
std::string EffectiveText(const JobRows& settings, const ReportedSettings& reported = {});

}  // namespace slicefarm::config
