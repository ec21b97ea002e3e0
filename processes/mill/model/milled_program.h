#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "processes/mill/model/mill_report.h"
#include "processes/mill/model/milled_step.h"

namespace slicefarm {

/// The steps of a job, in their order: phase by phase; levels from the top down, rows by y.
struct MillLayout {
  std::vector<MillStep> steps;
  std::vector<int32_t> weights;  ///< by step: about what each takes beside the others; above 0
  Eigen::AlignedBox3d part_mm;
  Eigen::AlignedBox3d stock_mm;
};

/// What a job comes to.
struct MilledProgram {
  std::string text;  ///< for the machine, or the picture that was asked for
  MillReport report;
};

}  // namespace slicefarm
