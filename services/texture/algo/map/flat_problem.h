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

using MapPoints = std::vector<Eigen::Vector2d>;
using Corners = std::array<int32_t, 3>;

/// What is minimised: symmetric Dirichlet energies of a surface's triangles and of the shell around
/// their map, and the barrier of its frame. Points are those of the map, then those of the shell.
class FlatProblem {
 public:
  FlatProblem(const SurfaceMesh& mesh, const BoundaryLoop& outer, const Shell& shell,
              const MapPoints& points);

  const std::vector<Corners>& triangles() const { return triangles_; }
  const std::vector<RestTriangle>& references() const { return references_; }
  const std::vector<int32_t>& frame() const { return frame_; }
  const FrameBarrier& barrier() const { return barrier_; }
  int32_t point_count() const { return point_count_; }
  double area() const { return area_; }  ///< of the surface

  /// What a triangle's energy counts, and a pair of the frame's.
  double WeightOf(size_t triangle) const {
    return triangle < surface_count_ ? rests_[triangle].area : shell_weight_;
  }
  double BarrierWeight() const;
  /// The weight of the whole shell as a share of the surface's area.
  void WeighShell(double share);

  /// Of the surface, by area, over 4, from its true shape.
  double MeanEnergy(const MapPoints& points) const;
  /// Of all, from the references; infinite if a triangle flips or the frame crosses itself.
  double TotalEnergy(const MapPoints& points) const;

  /// Takes references from which no triangle of the map is far. True: they are the true shapes.
  /// Source: Liu, Ye, Ni, Fu, "Progressive Parameterizations", ACM TOG 37 (2018), but triangle
  /// by triangle, and with stretches cut where the paper takes a power of them.
  bool ApproachReferences(const MapPoints& points);
  void TakeTrueReferences() { references_ = rests_; }

  /// How far the points may go until the first triangle is flat.
  double StepBound(const MapPoints& points, const MapPoints& direction) const;

  /// Whether no triangle flips and the frame does not cross itself, in exact arithmetic: then the
  /// map is one-to-one.
  bool IsOneToOne(const MapPoints& points) const;

  MapPoints FrameOf(const MapPoints& points) const;
  Eigen::Matrix2d JacobianAt(const MapPoints& points, size_t triangle,
                             const RestTriangle& rest) const;

 private:
  std::vector<Corners> triangles_;   ///< the surface's, then the shell's
  std::vector<RestTriangle> rests_;  ///< their true shapes
  std::vector<RestTriangle> references_;
  std::vector<int32_t> frame_;
  FrameBarrier barrier_;
  size_t surface_count_ = 0;
  int32_t point_count_ = 0;
  double area_ = 0;
  double shell_weight_ = 0;  ///< of a triangle
};

}  // namespace slicefarm::texture
