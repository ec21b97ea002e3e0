#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// What a path is part of.
enum class Feature : uint8_t {
  kExternalPerimeter,
  kPerimeter,
  kOverhangPerimeter,
  kGapFill,
  kInternalInfill,
  kSolidInfill,
  kTopSolidInfill,
  kBridgeInfill,
  kSkirt,
  kSupport,
  kSupportInterface,
  kIroning,
  kSolidOverBridge,
};
inline constexpr int kFeatureCount = 13;

/// "External perimeter", "Perimeter", ..., for reports.
std::string_view FeatureName(Feature feature);

/// The words of the `;TYPE:` comment, as PrusaSlicer's previewers read them: FeatureName, but for
/// solid infill over bridges, which is solid infill to them.
std::string_view FeatureType(Feature feature);

/// A bead to lay down: a line with a width at each point, as high as its layer.
/// Along an edge the width goes from one point's to the next one's; where two points in a row are
/// equal it steps. INVARIANT: points.size() >= 2; widths_nm.size() is 1 (the same everywhere) or
/// points.size().
struct Path {
  Feature feature = Feature::kPerimeter;
  int32_t settings = 0;    ///< index into the job's tables of region settings
  int32_t inset = 0;       ///< of walls: 0 is the outermost
  int32_t ring = -1;       ///< of closed walls of inset 0: the outline's ring that it follows
  bool closed = false;     ///< the last point joins the first, which is not repeated
  bool reversible = true;  ///< may be printed backwards
  int32_t tool = 0;        ///< 0: others are refused until tools exist
  std::vector<Point> points;
  std::vector<Coord> widths_nm;

  Coord WidthAt(size_t i) const { return widths_nm.size() == 1 ? widths_nm[0] : widths_nm[i]; }
  friend bool operator==(const Path&, const Path&) = default;
};

/// Whether the invariant holds.
bool WellFormed(const Path& path);

/// Where a path starts, and where it ends; the same for a closed one. REQUIRES: WellFormed.
Point StartOf(const Path& path);
Point EndOf(const Path& path);

/// Length in nm, the closing edge included.
double PathLength(const Path& path);

}  // namespace slicefarm
