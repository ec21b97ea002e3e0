#pragma once

#include <string>
#include <vector>

#include "common/model/layers/filament_use.h"
#include "common/model/layers/fill_use.h"
#include "common/model/layers/job_plan.h"
#include "common/model/print_times.h"
#include "services/coordinator/algo/pipeline/job_process.h"

namespace slicefarm::coordinator {

/// What a report tells of filament printing. As JSON: `file_name`, `filament` (mm, mm3, g, cost),
/// `features` (time, length, volume by feature), `infill` (density or coverage asked and got,
/// paths; by row of region settings, feature and pattern), `travel`, `times` (what else
/// print_time_s is spent on, and all of it by layer), `seams`.
struct FdmReport : OwnReport {
  std::string file_name;       ///< JobReport's
  FilamentUse filament;        ///< JobReport's
  ProgramStats stats;          ///< of all layers
  PrintTimes times;            ///< what print_time_s is spent on
  double travel_mm = 0;        ///< between layers included
  std::vector<FillUse> fills;  ///< of all copies, one a kind: see AddUse
  SeamQuality seams;           ///< of loops of objects, whatever their copies

  void AddTo(nlohmann::ordered_json& json) const override;
};

}  // namespace slicefarm::coordinator
