#pragma once

#include <string>
#include <vector>

#include "common/model/layers/filament_use.h"
#include "common/model/layers/fill_use.h"
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
struct FdmReport : OwnReport {
  std::string file_name;       ///< as in JobReport
  FilamentUse filament;        ///< as in JobReport
  ProgramStats stats;          ///< sum over all layers
  PrintTimes times;            ///< `print_time_s`, divided by cause
  double travel_mm = 0;        ///< includes travel between layers
  std::vector<FillUse> fills;  ///< sum over all copies, one entry per kind: see AddUse
  SeamQuality seams;  ///< counts each loop of an object once, independent of the number of copies

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
