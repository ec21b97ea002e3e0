#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// The planes of cubic infill (cubes that stand on a corner, services/infill/algo/patterns),
/// thinned out away from given places: an octree of cubes, each with the three planes through its
/// middle. There are the cubes in which a place lies, from those two plane distances wide up to
/// one as wide as all. So next to a place planes lie `pitch` apart (in the sense of the pattern's
/// density law), and at double the distance in a cube of double the size that holds no place. A
/// plane ends at the sides of its cubes, which are planes of greater cubes.
///
/// Each size's cubes lie so that they hold least of the body that is filled, of the eight ways in
/// which they can be put together from the next smaller ones: so planes thin out as soon as places
/// allow it. The planes themselves are always cubic infill's own.
class CubicOctree {
 public:
  using Cell = std::array<int32_t, 3>;
  struct CellHash {
    size_t operator()(const Cell& cell) const;
  };
  using Cells = std::unordered_set<Cell, CellHash>;            ///< only asked whether it has one
  using Shares = std::unordered_map<Cell, int64_t, CellHash>;  ///< of the body, by cube

  /// `pitch_nm`: length of lines per area is 1 / pitch where the tree is full. `angle_rad`: of the
  /// first family of lines. `reach_nm`: no coordinate is greater. REQUIRES: pitch_nm > 0.
  CubicOctree(double pitch_nm, double angle_rad, double reach_nm);

  /// Tells the tree of a place: it reaches `around_nm` far in the plane.
  void Add(Point place, Coord z_nm, double around_nm);
  /// Tells it of a place in the body; they lie evenly.
  void AddBody(Point place, Coord z_nm);
  /// How far apart places of the body are to be told, and those of its surface, which miss no more
  /// of a cube then than a corner.
  double BodyStepNm() const { return distance_; }
  double StepNm() const { return distance_ / 4; }

  /// Lays the cubes around the places, once all are told. Cost: O(area of places / distance^2).
  void Grow();

  /// The lines of the planes at a height, in order; straight, from where a plane begins to where it
  /// ends, not farther than the reach. REQUIRES: Grow was called. Cost: O(lines * cubes along
  /// each).
  std::vector<Polyline> LinesAt(double z_nm) const;

 private:
  /// Cubes of one size.
  struct Level {
    Cells cubes;
    Cell shift{};  ///< of their sides from the planes' origin, in plane distances
  };

  LineAxes FrameOf(int family) const { return frames_[static_cast<size_t>(family)]; }
  double EdgeOf(size_t level) const;
  /// Where a place lies, along the planes' normals, in plane distances.
  std::array<double, 3> AlongOf(Point place, Coord z_nm) const;
  /// The level in the middle of whose cubes a plane lies; levels_.size(): none, it goes on for
  /// ever.
  size_t LevelOf(int family, int64_t plane) const;
  std::vector<double> CutsOf(size_t level, int family, double mean, double half) const;
  void AddLine(int family, int64_t plane, double z_nm, std::vector<Polyline>& lines) const;

  double distance_;  ///< of neighbouring planes in space
  double reach_;
  std::array<LineAxes, 3> frames_;
  Cells places_;               ///< cubes as wide as planes are apart, in which a place lies
  Shares body_;                ///< of cubes of that width
  std::vector<Level> levels_;  ///< from the smallest cubes on
};

}  // namespace slicefarm::planning
