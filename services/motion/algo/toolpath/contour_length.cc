#include "services/motion/algo/toolpath/contour_length.h"

#include <cstddef>

#include "common/geometry/measure.h"

namespace slicefarm::motion {
namespace {

/// Longest step from wall to wall, in widths. It must exceed the longest link of
/// ordering/algo/near_links.h.
constexpr double kMostLinkWidths = 2.7;

bool IsPieceOfWall(const Path& path) {
  return (path.feature == Feature::kExternalPerimeter || path.feature == Feature::kPerimeter) &&
         !IsLoop(path);
}

bool GoesOn(const Path& path, const Path& next) { return EndOf(path) == StartOf(next); }

bool IsWallPath(const Path& path) {
  return path.feature == Feature::kExternalPerimeter || path.feature == Feature::kPerimeter;
}

/// Returns the index after the last of the connected pieces of walls that begin at `first`.
size_t EndOfRun(std::span<const Path> paths, size_t first) {
  size_t end = first + 1;
  while (end < paths.size() && IsPieceOfWall(paths[end]) && GoesOn(paths[end - 1], paths[end]))
    ++end;
  return end;
}

/// Returns true if path i only links a wall to the next one.
bool IsLink(std::span<const Path> paths, size_t i) {
  const Path& path = paths[i];
  return i > 0 && i + 1 < paths.size() && path.points.size() == 2 && IsPieceOfWall(path) &&
         PathLength(path) <= kMostLinkWidths * static_cast<double>(paths[i + 1].WidthAt(0)) &&
         IsWallPath(paths[i - 1]) && IsWallPath(paths[i + 1]) && GoesOn(paths[i - 1], path) &&
         GoesOn(path, paths[i + 1]);
}

}  // namespace

bool IsLoop(const Path& path) {
  return path.closed ||
         (path.points.size() > 2 && Distance(path.points.front(), path.points.back()) <=
                                        static_cast<double>(path.WidthAt(0)));
}

std::vector<double> ContourLengthsMm(std::span<const Path> paths) {
  std::vector<double> lengths(paths.size());
  for (size_t i = 0; i < paths.size(); ++i) lengths[i] = ToMm(PathLength(paths[i]));
  for (size_t first = 0; first < paths.size();) {
    const size_t end = IsPieceOfWall(paths[first]) ? EndOfRun(paths, first) : first + 1;
    double whole = 0;
    for (size_t i = first; i < end; ++i) whole += lengths[i];
    for (size_t i = first; i < end; ++i) lengths[i] = whole;
    first = end;
  }
  for (size_t i = paths.size(); i-- > 0;)
    if (IsLink(paths, i)) lengths[i] = lengths[i + 1];
  return lengths;
}

}  // namespace slicefarm::motion
