#include "services/milling/algo/push/fiber_frame.h"

#include <algorithm>

namespace slicefarm::milling {

FiberFrame::FiberFrame(const TriangleMesh& mesh, const MeshEdges& edges, FiberAxis axis)
    : mesh_(mesh), edges_(edges), axis_(axis) {
  points_.reserve(mesh.points_mm.size());
  for (const Eigen::Vector3d& p : mesh.points_mm)
    points_.push_back({AlongOf(p, axis), AcrossOf(p, axis), p.z()});
  corners_ = mesh.triangles;
  for (auto& corners : corners_) {
    std::sort(corners.begin(), corners.end(), [&](uint32_t a, uint32_t b) {
      return ByCoordinates(mesh.points_mm[a], mesh.points_mm[b]);
    });
  }
  normals_.reserve(mesh.triangles.size());
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t)
    normals_.push_back(NormalOf(CornersOf(t, {})));
}

std::array<FiberPoint, 3> FiberFrame::CornersOf(uint32_t triangle, const Fiber& fiber) const {
  const auto& corners = corners_[triangle];
  return {At(corners[0], fiber), At(corners[1], fiber), At(corners[2], fiber)};
}

Interval FiberFrame::Hull(const Cutter& cutter, uint32_t triangle, const Fiber& fiber,
                          const std::array<Reach, 3>& sides) const {
  Interval hull{sides[0].low, sides[0].high, {triangle, 0}, {triangle, 0}};
  for (uint32_t k = 1; k < 3; ++k) {
    if (sides[k].low < hull.low) hull.low = sides[k].low, hull.low_source = {triangle, k};
    if (sides[k].high > hull.high) hull.high = sides[k].high, hull.high_source = {triangle, k};
  }
  if (!(hull.low < hull.high)) return hull;
  const FacetContact facet = PushFacet(cutter, CornersOf(triangle, fiber), normals_[triangle]);
  if (facet.side > 0 && facet.end > hull.high)
    hull.high = facet.end, hull.high_source = {triangle, 3};
  if (facet.side < 0 && facet.end < hull.low) hull.low = facet.end, hull.low_source = {triangle, 3};
  return hull;
}

Interval FiberFrame::PushTriangle(const Cutter& cutter, uint32_t triangle,
                                  const Fiber& fiber) const {
  const auto& sides = edges_.of_triangle[triangle];
  return Hull(cutter, triangle, fiber,
              {PushSide(cutter, sides[0], fiber), PushSide(cutter, sides[1], fiber),
               PushSide(cutter, sides[2], fiber)});
}

Eigen::Vector3d FiberFrame::Unframed(const FiberPoint& p, const Fiber& fiber) const {
  const double across = p.across + fiber.across_mm, z = p.height + fiber.z_mm;
  return axis_ == FiberAxis::kX ? Eigen::Vector3d(p.along, across, z)
                                : Eigen::Vector3d(across, p.along, z);
}

Eigen::Vector3d FiberFrame::ContactOf(const Cutter& cutter, const Source& source,
                                      const Fiber& fiber, bool high) const {
  if (source.part == 3) {
    const auto corners = CornersOf(source.triangle, fiber);
    return Unframed(PushFacet(cutter, corners, normals_[source.triangle]).at, fiber);
  }
  const uint32_t edge = edges_.of_triangle[source.triangle][source.part];
  const Reach reach = PushSide(cutter, edge, fiber);
  const FiberPoint a = At(edges_.ends[edge][0], fiber), b = At(edges_.ends[edge][1], fiber);
  const double s = high ? reach.high_at : reach.low_at;
  return Unframed({a.along + s * (b.along - a.along), a.across + s * (b.across - a.across),
                   a.height + s * (b.height - a.height)},
                  fiber);
}

}  // namespace slicefarm::milling
