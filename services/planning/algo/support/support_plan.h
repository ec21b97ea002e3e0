#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// What a region of support is for, and so how it is printed.
enum class SupportRole : uint8_t {
  kBase,             ///< sparse lines, with a loop around them if a sheath is asked for
  kBranch,           ///< one loop, nothing in it
  kThickBranch,      ///< two loops, nothing in them
  kTopInterface,     ///< dense lines that the part lies on
  kBottomInterface,  ///< dense lines on the part
};
inline constexpr int kSupportRoleCount = 5;

struct SupportRegion {
  SupportRole role = SupportRole::kBase;
  MultiPolygon outlines;

  friend bool operator==(const SupportRegion&, const SupportRegion&) = default;
};

/// A layer of support; its heights need not be those of the part's layers.
struct SupportLayer {
  Coord top_nm = 0;     ///< above the bed
  Coord height_nm = 0;  ///< down to the top of the layer of support below, be it printed or not
  bool first = false;   ///< it lies on the bed
  std::vector<SupportRegion> regions;  ///< disjoint, by role; not empty

  friend bool operator==(const SupportLayer&, const SupportLayer&) = default;
};

/// What should be known of an overhang.
struct SupportFinding {
  enum class Kind : uint8_t {
    kNotCarried,   ///< an overhang that no support can reach
    kStartsInAir,  ///< an island with nothing of the part below it
  };
  Kind kind = Kind::kNotCarried;
  int32_t layer = 0;    ///< of the part
  Coord bottom_nm = 0;  ///< of that layer
  Point place;          ///< in the middle of it, or near
  double area_mm2 = 0;
  bool carried = false;  ///< of kStartsInAir: a support carries it

  friend bool operator==(const SupportFinding&, const SupportFinding&) = default;
};

struct SupportPlan {
  std::vector<SupportLayer> layers;      ///< upwards, one for each height
  std::vector<SupportFinding> findings;  ///< by layer of the part, then place
  /// By layer of the part: where supports lie right below its underside, grown a line wide.
  std::vector<MultiPolygon> carried;

  friend bool operator==(const SupportPlan&, const SupportPlan&) = default;
};

}  // namespace slicefarm::planning
