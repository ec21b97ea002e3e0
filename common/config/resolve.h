#pragma once

#include <span>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/missing_feature.h"
#include "common/config/told_settings.h"
#include "common/model/options/settings.h"
#include "common/model/setting.h"

namespace slicefarm::config {

using slicefarm::Setting;
using slicefarm::Source;

class ParsedTexts;

/// What parts are multiplied by, as their filament shrinks.
struct Growth {
  double xy = 1;
  double z = 1;
};

struct ResolvedSettings {
  JobRows settings;
  Growth growth;
  /// EffectiveText(settings, what was given besides). Resolve of its lines gives `settings` and the
  /// same text back.
  std::string effective_text;
  /// Settings that were given and have no effect, or not the full one: `key = value: why`.
  std::vector<std::string> no_effect;
  int64_t beside_print = 0;  ///< of no_effect: those that cannot matter to a print like this one
  /// Those of them that change what is printed, and other things worth a look.
  std::vector<std::string> warnings;
  std::vector<MissingFeature> missing;
};

/// Settings as text to settings as a job needs them: complete, in range, percentages worked out.
/// Later settings win, whatever the earlier ones say; what none gives has the standard of
/// settings_table.h.
///
/// Errors: REQUEST_TOO_LARGE past the limits, for what the layers' G-code names too;
/// SETTING_UNKNOWN for a kRequest key that neither slicefarm nor PrusaSlicer knows (metadata
/// `setting` and, where one comes near, `suggestion`); SETTING_OF_OTHER_PROCESS for a kRequest key
/// of another process (metadata `setting`, `process`); SETTING_MALFORMED; SETTING_OUT_OF_RANGE
/// (metadata `setting`, `value`, `min`, `max`), also where settings do not fit each other.
absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process);
/// The same of one of many sets that have long texts in common.
absl::StatusOr<ResolvedSettings> Resolve(std::span<const Setting> given, Process process,
                                         ParsedTexts& parsed);

/// All settings that have an effect on the job's process, and those that are told, as `key = value`
/// lines, sorted by key: equal texts for equal settings, and the other way round.
std::string EffectiveText(const JobRows& settings, const ToldSettings& told = {});

}  // namespace slicefarm::config
