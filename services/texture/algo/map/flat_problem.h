#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "services/texture/algo/map/distortion.h"
#include "services/texture/algo/map/frame.h"
#include "services/texture/algo/map/shell.h"
#include "services/texture/algo/surface/surface_mesh.h"

namespace slicefarm::texture {

/// Points of a map, in mm.
using MapPoints = std::vector<Eigen::Vector2d>;
/// Indices of the points at a triangle's corners.
using Corners = std::array<int32_t, 3>;

/// Function to minimize for a flat map. It is the sum of two parts: the symmetric Dirichlet
/// energies of the surface's triangles and of the shell around their map (shell.h), and the barrier
/// of the shell's frame (frame.h). The points of the map come first, then the points of the shell.
class FlatProblem {
 public:
  FlatProblem(const SurfaceMesh& mesh, const BoundaryLoop& outer, const Shell& shell,
              const MapPoints& points);

  /// Returns the triangles of the surface, then of the shell.
  const std::vector<Corners>& triangles() const { return triangles_; }
  /// Returns the shapes from which the energies are measured: the true shapes of the triangles, or
  /// shapes nearer to the map (ApproachReferences).
  const std::vector<RestTriangle>& references() const { return references_; }
  const std::vector<int32_t>& frame() const { return frame_; }
  /// Returns the barrier of the frame.
  const FrameBarrier& barrier() const { return barrier_; }
  int32_t point_count() const { return point_count_; }
  double area() const { return area_; }  ///< area of the surface

  /// Returns the weight of a triangle's energy.
  double WeightOf(size_t triangle) const {
    return triangle < surface_count_ ? rests_[triangle].area : shell_weight_;
  }
  /// Returns the weight of the barrier's energy between one edge and one point.
  double BarrierWeight() const;
  /// Sets the total weight of the shell's triangles to `share` times the surface's area.
  void WeighShell(double share);

  /// Returns the mean energy of the surface's triangles, weighted by area and divided by 4,
  /// measured from their true shapes; 1 without distortion.
  double MeanEnergy(const MapPoints& points) const;
  /// Returns the weighted energy of all triangles plus the barrier, measured from the references.
  /// Infinite if a triangle flips or the frame crosses itself.
  double TotalEnergy(const MapPoints& points) const;

  /// Sets references so near to the map that no triangle has a high energy. Returns true if all
  /// references are the true shapes. Source: Liu, Ye, Ni, Fu, "Progressive Parameterizations", ACM
  /// TOG 37 (2018). In contrast to the paper, each triangle is treated separately, and stretches
  /// are limited instead of raised to a power.
  bool ApproachReferences(const MapPoints& points);
  /// Sets the true shapes as references.
  void TakeTrueReferences() { references_ = rests_; }

  /// Returns the largest factor of `direction` up to which no triangle becomes flat; infinity if
  /// none ever does.
  double StepBound(const MapPoints& points, const MapPoints& direction) const;

  /// Returns true if no triangle flips and the frame does not cross itself, in exact arithmetic.
  /// Then the map is one-to-one.
  bool IsOneToOne(const MapPoints& points) const;

  /// Returns the points of the frame.
  MapPoints FrameOf(const MapPoints& points) const;
  /// Returns the Jacobian of the map from `rest`, an undistorted triangle, to a triangle of the
  /// map.
  Eigen::Matrix2d JacobianAt(const MapPoints& points, size_t triangle,
                             const RestTriangle& rest) const;

 private:
  std::vector<Corners> triangles_;   ///< triangles of the surface, then of the shell
  std::vector<RestTriangle> rests_;  ///< true shapes of the triangles
  std::vector<RestTriangle> references_;
  std::vector<int32_t> frame_;
  FrameBarrier barrier_;
  size_t surface_count_ = 0;
  int32_t point_count_ = 0;
  double area_ = 0;
  double shell_weight_ = 0;  ///< weight of one triangle of the shell
};

}  // namespace slicefarm::texture
