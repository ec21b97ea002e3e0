#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

/// Returns true for features of walls, including walls over air.
inline bool IsWall(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kPerimeter ||
         feature == Feature::kOverhangPerimeter;
}

/// Returns true for closed paths of walls, skirts and brims.
inline bool IsLoopOfWalls(const Path& path) {
  return path.closed && (IsWall(path.feature) || path.feature == Feature::kSkirt);
}

/// Returns true for beads of a top surface.
inline bool IsTop(Feature feature) {
  return feature == Feature::kTopSolidInfill || feature == Feature::kIroning;
}

/// Returns true for solid infill and gap fill.
inline bool IsFill(Feature feature) {
  return feature == Feature::kGapFill || feature == Feature::kSolidInfill ||
         feature == Feature::kTopSolidInfill || feature == Feature::kSolidOverBridge;
}

}  // namespace slicefarm::motion
