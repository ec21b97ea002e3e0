#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Phase of a milling job. Each phase consists of steps; the comments describe one step of the
/// phase.
enum class MillPhase : uint8_t {
  kRoughing,   ///< level at which all stock above is removed, except the allowance
  kFinishing,  ///< level of toolpaths that touch the part
  kRest,       ///< row along x over surfaces that are too flat for levels
};
inline constexpr int kMillPhaseCount = 3;

/// Smallest unit of work. Any range of a job's steps can be computed independently of the rest.
struct MillStep {
  MillPhase phase = MillPhase::kRoughing;
  double at_mm = 0;  ///< z of a level, or y of a row

  friend bool operator==(const MillStep&, const MillStep&) = default;
};

/// Range [first, last) of a job's steps.
struct StepRange {
  int32_t first = 0;
  int32_t last = 0;

  int32_t size() const { return last - first; }
  friend bool operator==(const StepRange&, const StepRange&) = default;
};

/// Connected area on a level in which the tip can move, with the toolpaths in it, in nm.
struct CutArea {
  PolygonWithHoles area;
  /// Toolpaths in the order and direction of cutting. Each one is closed; the first point is not
  /// repeated.
  std::vector<Polygon> passes;

  friend bool operator==(const CutArea&, const CutArea&) = default;
};

/// Toolpath of the tip along x, in mm.
using RestRun = std::vector<Eigen::Vector3d>;

/// Result of a step: the areas of a level, or the runs of a row.
struct MilledStep {
  MillStep step;
  std::vector<CutArea> areas;
  std::vector<RestRun> runs;

  friend bool operator==(const MilledStep&, const MilledStep&) = default;
};

}  // namespace slicefarm
