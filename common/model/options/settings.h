#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/exposure_settings.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/slicing_options.h"
#include "common/model/process.h"

namespace slicefarm {

/// What a job is to be made with: one struct a stage, complete and validated (common/config does
/// both at the edge). What regions have of their own stands in tables with a row for each: Region
/// and Path name the row. INVARIANT: all tables of regions are equally long, and not empty.
struct JobSettings {
  Process process = kDefaultProcess;  ///< options of stages of other processes have no effect
  SlicingOptions slicing;
  PlanningOptions planning;
  std::vector<BeadingOptions> beading = {{}};  ///< by region
  std::vector<InfillOptions> infill = {{}};    ///< by region
  OrderingOptions ordering;
  MotionOptions motion;
  ExposureSettings exposure;

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// How many of an object's own layers on each side a layer's result depends on.
int32_t HaloLayers(const JobSettings& settings);

/// What planning is told of the infill of each region; empty if it has nothing to decide.
std::vector<InfillPlanOptions> InfillPlansOf(const JobSettings& settings);

/// Of those, how many the walls depend on.
int32_t BeadingHaloLayers(const JobSettings& settings);

}  // namespace slicefarm
