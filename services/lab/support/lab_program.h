#pragma once

#include <string>
#include <vector>

#include "services/planning/algo/support/support_plan.h"
#include "services/planning/algo/support/support_problem.h"

namespace slicefarm::lab {

/// How supports are laid in a lab program.
struct LabBeads {
  Coord part_width_nm = 450'000;
  Coord support_width_nm = 350'000;
  Coord spacing_nm = 2'500'000;  ///< free between lines of the base
};

/// G-code that judges read, of the part's outer walls and all of its supports: a loop around each
/// region (two of thick branches), dense lines in interfaces, and on the bed, spaced ones in bases,
/// none in branches. Not for printing: there is nothing in the part, and no travel is planned.
/// Cost: O(length of all beads).
std::string LabProgram(const planning::SupportProblem& problem, const planning::SupportPlan& plan,
                       const LabBeads& beads);

}  // namespace slicefarm::lab
