#pragma once

#include <string>
#include <vector>

#include "common/model/calibration_table.h"
#include "common/model/setting_source.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// Facts about a job that the pipeline does not have and the caller adds to the report.
struct ReportContext {
  /// Keys of settings that were given but had no effect.
  std::vector<std::string> settings_without_effect = {};
  std::string settings_digest = {};
  std::string build_id = {};
  CalibrationTable calibration = {};        ///< values that a calibration print compares
  std::vector<SettingSource> sources = {};  ///< sources of the settings of a job with presets
};

/// Returns the report as JSON. Keys: `meshes`, `layers`, `object_height_mm`, `print_time_s`,
/// `print_time`, the keys of ProcessReport, `stage_times_s`, `warnings`, `notes`,
/// `settings_without_effect`, `settings_digest`, `build_id`, `calibration` of a calibration print,
/// and `setting_sources` of a job with presets. Replaces bytes of names that are not UTF-8.
std::string ReportJson(const JobReport& report, const ReportContext& context);

}  // namespace slicefarm::coordinator
