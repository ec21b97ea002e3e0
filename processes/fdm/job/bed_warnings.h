#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/stage/stages.h"

namespace slicefarm::coordinator {

/// Which brims, rafts and skirts end at the bed's edge, where planning cuts them: a sentence for
/// each kind, which names the objects nearest to the cuts. `bed`: as in PlanningOptions. `names`:
/// by object.
/// Cost: two boolean operations for each region that is near the edge.
std::vector<std::string> BedWarnings(std::span<const PlateAddition> additions, const Polygon& bed,
                                     std::span<const PlacedCopy> copies,
                                     std::span<const std::string> names);

}  // namespace slicefarm::coordinator
