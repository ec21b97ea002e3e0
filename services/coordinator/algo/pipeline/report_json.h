#pragma once

#include <string>
#include <vector>

#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// What the edge knows about a job beyond its report.
struct ReportContext {
  std::vector<std::string> settings_without_effect =
      {};  ///< keys that were given and changed nothing
  std::string settings_digest = {};
  std::string build_id = {};
};

/// The report as JSON: `meshes`, `layers`, `print_time_s` and `print_time`, what is of the process
/// alone (OwnReport), `stage_times_s`, `warnings`, `settings_without_effect`. Names that are no
/// UTF-8 get replacement characters. Units stand in the names.
std::string ReportJson(const JobReport& report, const ReportContext& context);

}  // namespace slicefarm::coordinator
