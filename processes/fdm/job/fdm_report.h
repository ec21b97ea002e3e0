#pragma once

#include <string>
#include <vector>

#include "common/model/layers/filament_use.h"
#include "common/model/layers/fill_stats.h"
#include "common/model/layers/job_plan.h"
#include "common/model/print_times.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// FDM part of a job report. As JSON:
/// - `file_name`
/// - `filament`: mm, mm3, g, cost
/// - `features`: time, length and volume per feature
/// - `infill`: requested and actual density or coverage, and paths, per region settings, feature
///   and pattern
/// - `travel`
/// - `times`: parts of print_time_s that are not features, and the total time per layer
/// - `seams`
struct FdmReport : ProcessReport {
  std::string file_name;  ///< name of the file, equal to JobReport's
  FilamentUse filament;   ///< used filament, equal to JobReport's
  ProgramStats stats;     ///< sum over all layers
  PrintTimes times;       ///< `print_time_s`, divided by cause
  double travel_mm = 0;   ///< length of travels, including travels between layers
  /// totals of the infill over all copies, one entry per kind: see AddUse
  std::vector<FillStats> fills;
  /// quality of the seams; each loop of an object counts once, independent of the number of copies
  SeamQuality seams;

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
