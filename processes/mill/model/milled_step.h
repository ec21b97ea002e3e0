#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

enum class MillPhase : uint8_t {
  kRoughing,   ///< a level: all stock above it goes, but for the allowance
  kFinishing,  ///< a level: ways that touch the part
  kRest,       ///< a row along x: what is too flat for levels
};
inline constexpr int kMillPhaseCount = 3;

/// The least piece of work: any range of a job's steps can be made apart from the others.
struct MillStep {
  MillPhase phase = MillPhase::kRoughing;
  double at_mm = 0;  ///< z of a level, y of a row

  friend bool operator==(const MillStep&, const MillStep&) = default;
};

/// [first, last) of a job's steps.
struct StepRange {
  int32_t first = 0;
  int32_t last = 0;

  int32_t size() const { return last - first; }
  friend bool operator==(const StepRange&, const StepRange&) = default;
};

/// One connected part of a level's free area, and the ways of the tip in it, in nm.
struct CutArea {
  PolygonWithHoles area;
  /// In the order of cutting, turned as the direction of cutting wants; closed without repeating
  /// the first point.
  std::vector<Polygon> ways;

  friend bool operator==(const CutArea&, const CutArea&) = default;
};

/// A way of the tip, in mm, along x.
using RestRun = std::vector<Eigen::Vector3d>;

/// What became of a step: areas of a level, or runs of a row.
struct MilledStep {
  MillStep step;
  std::vector<CutArea> areas;
  std::vector<RestRun> runs;

  friend bool operator==(const MilledStep&, const MilledStep&) = default;
};

}  // namespace slicefarm
