#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "processes/mill/model/mill_report.h"
#include "processes/mill/model/milled_step.h"

namespace slicefarm {

/// Steps of a job in machining order: sorted by phase; then levels from the top down, or rows by
/// ascending y.
struct MillLayout {
  std::vector<MillStep> steps;
  std::vector<int32_t> weights;  ///< approximate relative effort of each step; above 0
  Eigen::AlignedBox3d part_mm;
  Eigen::AlignedBox3d stock_mm;
};

/// Result of a milling job.
struct MilledProgram {
  std::string text;  ///< program for the machine, or the requested picture
  MillReport report;
};

}  // namespace slicefarm
