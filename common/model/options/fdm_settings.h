#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"

namespace slicefarm {

/// What filament is laid down with: one struct a stage. What regions have of their own stands in
/// tables with a row for each: Region and Path name the row. INVARIANT: all tables of regions are
/// equally long, and not empty.
struct FdmSettings {
  PlanningOptions planning;
  std::vector<BeadingOptions> beading = {{}};  ///< by region
  std::vector<InfillOptions> infill = {{}};    ///< by region
  OrderingOptions ordering;
  MotionOptions motion;

  friend bool operator==(const FdmSettings&, const FdmSettings&) = default;
};

/// How many of an object's own layers on each side a layer's result depends on.
int32_t HaloLayers(const FdmSettings& settings);

/// Of those, how many the walls depend on.
int32_t BeadingHaloLayers(const FdmSettings& settings);

/// What planning is told of the infill of each region; empty if it has nothing to decide.
std::vector<InfillPlanOptions> InfillPlansOf(const FdmSettings& settings);

}  // namespace slicefarm
