#pragma once

#include <cstdint>
#include <vector>

#include "absl/container/flat_hash_map.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Where an object is, roughly: its outlines stacked up in cells of a millimetre, coarser for
/// objects of more than 256 mm. Tells how much is seen of a place on its surface.
class Occupancy {
 public:
  /// A section whose layer reaches up to `top_nm` above the object's bottom; of those that end in
  /// one millimetre of height the first counts. Cost: O(edges * millimetres of height in y).
  void Add(const MultiPolygon& outlines, Coord top_nm);

  /// To be called after Adds and before Visibility, which then knows them. Cost: O(volume in
  /// cells).
  void Build();

  /// Which share of the directions from a place on the surface leads out of the object, or 30 mm
  /// far: of twelve, up to 60 degrees to the sides and 45 up and down. As seen from the first place
  /// that was asked for of those in a patch, a cube of 4 mm, with the same direction `outward`
  /// (Bend::Outward). In [0, 1]. Cost: O(30 mm) for a new patch.
  double Visibility(Point at, Coord z_nm, int outward);

 private:
  /// Cells [first, last) of a row at millimetre `slab` of height.
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

  std::vector<Run> runs_;  ///< of the millimetre grid
  int32_t last_slab_ = -1;
  int32_t cell_mm_ = 1;
  Cell least_;
  Cell size_;
  std::vector<uint64_t> solid_;  ///< a bit for each cell
  absl::flat_hash_map<uint64_t, float> seen_;  ///< by patch and direction
};

}  // namespace slicefarm::planning
