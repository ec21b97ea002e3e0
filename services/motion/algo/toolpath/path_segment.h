#pragma once

#include <cstddef>

#include "common/geometry/point.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// Straight bead of a path. It begins at the end of the preceding segment.
struct PathSegment {
  Point from, to;
  Coord width_nm = 0;
};

/// Returns the number of straight beads of a path.
inline size_t SegmentsOf(const Path& path) { return path.points.size() - (path.closed ? 0 : 1); }

/// Returns edge `i` with the mean width of its ends. DividedByWidth (divided_path.h) keeps both
/// widths nearly equal.
inline PathSegment SegmentOf(const Path& path, size_t i) {
  const size_t to = i + 1 < path.points.size() ? i + 1 : 0;
  return {path.points[i], path.points[to], (path.WidthAt(i) + path.WidthAt(to)) / 2};
}

}  // namespace slicefarm::motion
