#pragma once

#include "common/model/path.h"

namespace slicefarm::motion {

inline bool IsWall(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kPerimeter ||
         feature == Feature::kOverhangPerimeter;
}

inline bool IsLoopOfWalls(const Path& path) {
  return path.closed && (IsWall(path.feature) || path.feature == Feature::kSkirt);
}

inline bool IsTop(Feature feature) {
  return feature == Feature::kTopSolidInfill || feature == Feature::kIroning;
}

inline bool IsFill(Feature feature) {
  return feature == Feature::kGapFill || feature == Feature::kSolidInfill ||
         feature == Feature::kTopSolidInfill || feature == Feature::kSolidOverBridge;
}

}  // namespace slicefarm::motion
