#pragma once

#include <string>
#include <vector>

#include "services/planning/algo/supports/generator/support_plan.h"
#include "services/planning/algo/supports/generator/support_problem.h"

namespace slicefarm::lab {

/// Bead widths and spacing of supports in a lab program.
struct LabBeads {
  Coord part_width_nm = 450'000;
  Coord support_width_nm = 350'000;
  Coord spacing_nm = 2'500'000;  ///< gap between lines of the base
};

/// Returns G-code with the part's outer walls and all of its supports, for other programs that
/// evaluate supports. Each support region has a loop around it (thick branches have two).
/// Interfaces and the first layer have dense lines, bases have spaced lines, and branches have no
/// lines. The program is not for printing: the part is empty inside, and travel is not planned.
/// Cost: O(total length of the beads).
std::string LabProgram(const planning::SupportProblem& problem, const planning::SupportPlan& plan,
                       const LabBeads& beads);

}  // namespace slicefarm::lab
