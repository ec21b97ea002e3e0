#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Purpose of a region of support, which decides how the region is printed.
enum class SupportRole : uint8_t {
  kBase,             ///< sparse lines, with a loop around them if a sheath is set
  kBranch,           ///< one loop without filling
  kThickBranch,      ///< two loops without filling
  kTopInterface,     ///< dense lines below the part
  kBottomInterface,  ///< dense lines on the part
};
inline constexpr int kSupportRoleCount = 5;

/// Area of one role in a layer of support.
struct SupportRegion {
  SupportRole role = SupportRole::kBase;
  MultiPolygon outlines;

  friend bool operator==(const SupportRegion&, const SupportRegion&) = default;
};

/// Layer of support. Its heights may differ from the heights of the part's layers.
struct SupportLayer {
  Coord top_nm = 0;  ///< top above the bed
  /// height above the top of the layer of support below, even if that layer is not printed
  Coord height_nm = 0;
  bool first = false;                  ///< true if the layer is on the bed
  std::vector<SupportRegion> regions;  ///< disjoint regions, sorted by role; not empty

  friend bool operator==(const SupportLayer&, const SupportLayer&) = default;
};

/// Warning about an overhang, for the user.
struct SupportFinding {
  enum class Kind : uint8_t {
    kUnsupported,  ///< overhang that no support can reach
    kStartsInAir,  ///< island that does not touch the part's layer below
  };
  Kind kind = Kind::kUnsupported;
  int32_t layer = 0;    ///< index of the part's layer with the overhang
  Coord bottom_nm = 0;  ///< bottom of this layer, above the bed
  Point place;          ///< centroid of the overhang's outer ring, in the object's coordinates
  double area_mm2 = 0;
  bool above_supports = false;  ///< for kStartsInAir: true if a support is below the island

  friend bool operator==(const SupportFinding&, const SupportFinding&) = default;
};

/// Supports of one object, and the warnings about its overhangs.
struct SupportPlan {
  std::vector<SupportLayer> layers;  ///< layers bottom up, one for each height
  /// warnings, sorted by the part's layer, then by the point
  std::vector<SupportFinding> findings;
  /// Areas of the part directly above supports, with a margin of a line's width; indexed by layer
  /// of the part.
  std::vector<MultiPolygon> above_supports;

  friend bool operator==(const SupportPlan&, const SupportPlan&) = default;
};

}  // namespace slicefarm::planning
