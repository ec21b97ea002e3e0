#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/point.h"

namespace slicefarm {

enum class SeamPosition : uint8_t { kNearest, kRear, kAligned };

/// What planning is told of one object.
struct ObjectPlanOptions {
  SeamPosition seam = SeamPosition::kAligned;  ///< seam_position

  friend bool operator==(const ObjectPlanOptions&, const ObjectPlanOptions&) = default;
};

struct PlanningOptions {
  std::vector<ObjectPlanOptions> objects = {{}};  ///< by object

  friend bool operator==(const PlanningOptions&, const PlanningOptions&) = default;
};

}  // namespace slicefarm
