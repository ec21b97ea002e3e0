#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"

namespace slicefarm::coordinator {

/// Returns warnings about brims, rafts and skirts that end at the boundary of the bed or of an
/// excluded area, where planning cuts them. There is one sentence for each kind, which names the
/// objects nearest to the cuts. Planning never cuts the objects themselves. `bed`: as in
/// PlanningOptions. `names`: one per object. Cost: two boolean operations for each region that is
/// near the boundary.
std::vector<std::string> BedWarnings(const JobPlan& plan, const MultiPolygon& bed,
                                     std::span<const PlacedCopy> copies,
                                     std::span<const std::string> names);

}  // namespace slicefarm::coordinator
