#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm {

/// Kind of feature to which a path belongs.
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
  kInternalBridge,
};
inline constexpr int kFeatureCount = 14;

/// Returns true for infill that is a bridge: over air, or over sparse infill.
inline bool IsBridge(Feature feature) {
  return feature == Feature::kBridgeInfill || feature == Feature::kInternalBridge;
}

/// Returns the name of a feature for reports: "External perimeter", "Perimeter", ...
std::string_view FeatureName(Feature feature);

/// Returns the text of the `;TYPE:` comment that PrusaSlicer's previewers read. The text is
/// FeatureName, with two exceptions: solid infill over bridges is reported as solid infill, and
/// bridges over sparse infill as bridges.
std::string_view FeatureType(Feature feature);

/// Bead to print: a line with a width at each point and the height of its layer. Between two points
/// the width changes linearly. Two equal consecutive points change the width at once. INVARIANT:
/// points.size() >= 2; widths_nm.size() is 1 (constant width) or points.size().
struct Path {
  Feature feature = Feature::kPerimeter;
  int32_t settings = 0;  ///< index into the job's tables of region settings
  int32_t inset = 0;     ///< number of the wall, for walls; 0 is the outermost
  /// index of the outline's ring that the path follows (OutlineOf); set for closed walls of inset 0
  int32_t ring = -1;
  bool closed = false;     ///< true if the last point connects to the first, which is not repeated
  bool reversible = true;  ///< true if the path may be printed backwards
  /// Index of the tool. Only 0 is accepted, because several tools are not supported yet.
  int32_t tool = 0;
  std::vector<Point> points;
  std::vector<Coord> widths_nm;

  Coord WidthAt(size_t i) const { return widths_nm.size() == 1 ? widths_nm[0] : widths_nm[i]; }
  friend bool operator==(const Path&, const Path&) = default;
};

/// Returns true if the path's invariant holds.
bool WellFormed(const Path& path);

/// Returns the start and the end of a path. Both are the same point for a closed path. REQUIRES:
/// WellFormed.
Point StartOf(const Path& path);
Point EndOf(const Path& path);

/// Returns the length in nm, including the closing edge.
double PathLength(const Path& path);

}  // namespace slicefarm
