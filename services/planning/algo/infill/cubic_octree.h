#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/geometry/line_axes.h"
#include "common/geometry/polygon.h"

namespace slicefarm::planning {

/// Planes of cubic infill that become sparser away from given points: an octree of cubes that stand
/// on a corner (services/infill/algo/patterns). Each cube has three planes through its middle.
///
/// The tree has every cube that contains one of the points, in each size from two plane distances
/// up to one cube that contains everything. So lines near a point are `pitch` apart (as in the
/// density formula of the pattern). In a cube of double size without points they are two pitches
/// apart, and so on. A plane ends at the sides of its cubes, which are planes of larger cubes.
///
/// Eight cubes of one size can be grouped into a larger cube at eight different offsets. The tree
/// uses the offset for which the larger cubes in the tree contain the smallest share of the filled
/// body. So planes become sparse as soon as possible. The planes themselves are always planes of
/// cubic infill.
class CubicOctree {
 public:
  using Cell = std::array<int32_t, 3>;
  /// Hash of a cell's three coordinates.
  struct CellHash {
    size_t operator()(const Cell& cell) const;
  };
  /// Set of cells, only for look-ups: its order is never used.
  using Cells = std::unordered_set<Cell, CellHash>;
  using Shares = std::unordered_map<Cell, int64_t, CellHash>;  ///< number of body samples per cube

  /// `pitch_nm`: distance between lines near the points; the length of lines per area is 1 /
  /// pitch_nm there. `angle_rad`: direction of the first family of lines. `reach_nm`: upper limit
  /// of all coordinates' absolute values. REQUIRES: pitch_nm > 0.
  CubicOctree(double pitch_nm, double angle_rad, double reach_nm);

  /// Adds a point near which planes are close together. The same holds for the area around the
  /// point with the radius `around_nm`, in the plane of the layer.
  void Add(Point point, Coord z_nm, double around_nm);
  /// Adds one sample point of the filled body. Samples must be evenly spaced, BodyStepNm() apart.
  void AddBody(Point point, Coord z_nm);
  /// Returns the distance in nm at which the body has to be sampled. With samples this close, at
  /// most a corner of a cube is missed.
  double BodyStepNm() const { return distance_; }
  /// Returns the distance in nm at which points have to be added along the body's surface.
  double StepNm() const { return distance_ / 4; }

  /// Builds the cubes around the points. Call it once, after all points are added. Cost: O(area of
  /// points / distance^2), where distance is the distance between planes in space.
  void Grow();

  /// Returns the lines of all planes at a height: straight lines, sorted by family, then by plane.
  /// A plane has several lines if it is interrupted. REQUIRES: Grow was called. Cost: O(lines *
  /// cubes along each).
  std::vector<Polyline> LinesAt(double z_nm) const;

 private:
  /// All cubes of one size.
  struct Level {
    Cells cubes;
    Cell shift{};  ///< offset of the cubes' sides from the planes' origin, in plane distances
  };

  LineAxes FrameOf(int family) const { return frames_[static_cast<size_t>(family)]; }
  double EdgeOf(size_t level) const;
  /// Returns the coordinates of a point along the planes' normals, in plane distances.
  std::array<double, 3> AlongOf(Point point, Coord z_nm) const;
  /// Returns the level of the cubes that have this plane in their middle. If the result is
  /// levels_.size(), no cube limits the plane.
  size_t LevelOf(int family, int64_t plane) const;
  std::vector<double> CutsOf(size_t level, int family, double mean, double half) const;
  void AddLine(int family, int64_t plane, double z_nm, std::vector<Polyline>& lines) const;

  double distance_;  ///< distance between neighbouring planes in space
  double reach_;
  std::array<LineAxes, 3> frames_;
  Cells places_;               ///< cubes with a side of one plane distance that contain a point
  Shares body_;                ///< body samples per cube with a side of one plane distance
  std::vector<Level> levels_;  ///< levels from the smallest cubes to the largest
};

}  // namespace slicefarm::planning
