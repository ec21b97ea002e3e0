#pragma once

#include <cstdint>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Coarse model of an object: a grid of cubic cells, which are solid where the outlines of the
/// object's layers cover them. A cell is a millimetre wide, or wider for objects of more than 256
/// mm. The model tells how visible points on the surface are.
class Occupancy {
 public:
  /// Adds a section with its top at `top_nm` above the object's bottom. Call it from the lowest
  /// section up. Of several sections with tops in the same millimetre only the first counts. Cost:
  /// O(edges * millimetres of height in y).
  void Add(const MultiPolygon& outlines, Coord top_nm);

  /// Builds the cells from the added sections. Call after Add and before Visibility. Cost: O(volume
  /// in cells).
  void Build();

  /// Returns the visibility of a point on the surface, in [0, 1]. Twelve rays lead from the point
  /// away from the surface. Their angles are up to 60 degrees to the sides and 45 degrees up and
  /// down. The visibility is the share of rays that meet no solid cell within 30 mm.
  ///
  /// All points in a patch (a cube of 4 mm) with the same direction `outward` (Bend::Outward) share
  /// one value. It is computed for the first point of the patch that a call asks for. Cost: O(30
  /// mm) for a new patch.
  double Visibility(Point at, Coord z_nm, int outward);

 private:
  /// Solid cells [first, last) of one row, in the slab with index `slab` in millimetres of height.
  struct Run {
    int32_t slab = 0;
    int32_t row = 0;
    int32_t first = 0;
    int32_t last = 0;
  };
  struct Cell {
    int32_t x = 0;
    int32_t y = 0;
    int32_t z = 0;
  };

  bool IsSolid(Cell cell) const;
  bool LeadsOut(const double from[3], const double step[3]) const;
  double SeenFrom(Cell cell, int outward) const;

  std::vector<Run> runs_;  ///< solid runs of the millimetre grid
  int32_t last_slab_ = -1;
  int32_t cell_mm_ = 1;
  Cell least_;
  Cell size_;
  std::vector<uint64_t> solid_;                ///< one bit per cell
  absl::flat_hash_map<uint64_t, float> seen_;  ///< visibility per patch and direction
};

}  // namespace slicefarm::planning
