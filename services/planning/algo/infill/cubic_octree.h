#pragma once

#include <array>
#include <cstdint>
#include <unordered_set>
#include <vector>

#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The planes of cubic infill (cubes that stand on a corner, services/infill/algo/patterns),
/// thinned out away from given points: an octree of cubes, each with the three planes through its
/// middle. A cube is divided if a point lies in the ball around it. So planes lie `pitch` apart (in
/// the sense of the pattern's density law) next to points, and at double the distance each time
/// that the distance to the points doubles.
class CubicOctree {
 public:
  /// `pitch_nm`: length of lines per area is 1 / pitch where the tree is full. `angle_rad`: of the
  /// first family of lines. `reach_nm`: no coordinate is greater. REQUIRES: pitch_nm > 0.
  CubicOctree(double pitch_nm, double angle_rad, double reach_nm);

  /// Divides the cubes around a point. Points nearer to each other than StepNm tell nothing new.
  void Add(Point place, Coord z_nm);
  double StepNm() const { return step_; }

  /// The lines of the planes at a height, in order; straight, from where a plane begins to where it
  /// ends, not farther than the reach. Cost: O(lines * cubes along each).
  std::vector<Polyline> LinesAt(double z_nm) const;

 private:
  using Cell = std::array<int32_t, 3>;
  struct CellHash {
    size_t operator()(const Cell& cell) const;
  };
  using Cells = std::unordered_set<Cell, CellHash>;  ///< only asked whether it has one

  LineAxes FrameOf(int family) const { return frames_[static_cast<size_t>(family)]; }
  double EdgeOf(int level) const;
  bool Exists(int level, const Cell& cell) const;
  void AddLine(int family, int64_t plane, double z_nm, std::vector<Polyline>& lines) const;

  double distance_;  ///< of neighbouring planes in space
  double reach_;
  double step_;
  std::array<LineAxes, 3> frames_;
  int levels_ = 0;              ///< of the smallest cubes; 0 is the whole
  std::vector<Cells> divided_;  ///< cubes by level, those of level 0 left out
  Cells seen_;                  ///< steps in which there was a point
};

}  // namespace slicefarm::planning
