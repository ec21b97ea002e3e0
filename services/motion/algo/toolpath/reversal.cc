#include "services/motion/algo/toolpath/reversal.h"

#include <algorithm>
#include <vector>

#include "common/geometry/measure.h"
#include "services/motion/algo/toolpath/feature_groups.h"
#include "services/motion/algo/toolpath/path_segment.h"

namespace slicefarm::motion {
namespace {

/// Returns the greatest overhang of a wall's edge beyond the layer below, in mm.
double OverhangMm(const Path& path, const LayerBelow& below) {
  std::vector<PathSegment> segments(SegmentsOf(path));
  for (size_t i = 0; i < segments.size(); ++i) segments[i] = SegmentOf(path, i);
  double most_mm = 0;
  for (const RestingPiece& piece : PiecesOver(below, RestSteps::kAll, segments)) {
    const double width_mm = ToMm(segments[piece.segment].width_nm);
    most_mm = std::max(most_mm, width_mm * (kFullRest - piece.rest) / kFullRest);
  }
  return most_mm;
}

}  // namespace

bool IsReversed(const Path& path, const OverhangReversal& reversal, int32_t layer,
                const LayerBelow* below) {
  if (!reversal.on || layer % 2 == 0 || !path.closed || !IsWall(path.feature)) return false;
  if (reversal.inner_only && path.feature == Feature::kExternalPerimeter) return false;
  if (reversal.threshold_mm <= 0) return true;
  return below != nullptr && OverhangMm(path, *below) > reversal.threshold_mm;
}

Path Reversed(Path path) {
  std::reverse(path.points.begin() + 1, path.points.end());
  if (path.widths_nm.size() > 1) std::reverse(path.widths_nm.begin() + 1, path.widths_nm.end());
  return path;
}

}  // namespace slicefarm::motion
