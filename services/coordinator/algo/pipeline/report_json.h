#pragma once

#include <string>
#include <vector>

#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Facts about a job that only the entry point has, for the report.
struct ReportContext {
  /// Keys of settings that were given but had no effect.
  std::vector<std::string> settings_without_effect = {};
  std::string settings_digest = {};
  std::string build_id = {};
};

/// Returns the report as JSON: `meshes`, `layers`, `print_time_s` and `print_time`, the process's
/// own part (OwnReport), `stage_times_s`, `warnings`, `settings_without_effect`. Replaces bytes of
/// names that are no UTF-8. The names of keys contain their units.
std::string ReportJson(const JobReport& report, const ReportContext& context);

}  // namespace slicefarm::coordinator
