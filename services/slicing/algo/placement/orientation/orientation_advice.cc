#include "services/slicing/algo/placement/orientation/orientation_advice.h"

#include <Eigen/Core>
#include <Eigen/LU>

#include "services/slicing/algo/placement/orientation/orientation.h"

namespace slicefarm::slicing {
namespace {

/// Smallest gain in score that justifies rotating an object. It equals an overhang area smaller by
/// a fortieth of the hull's surface.
constexpr double kLeastGain = 0.025;

IndexedMesh Together(std::span<const IndexedMesh* const> parts) {
  IndexedMesh all;
  for (const IndexedMesh* part : parts) {
    const auto first = static_cast<uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part->vertices.begin(), part->vertices.end());
    for (const auto& [a, b, c] : part->triangles)
      all.triangles.push_back({first + a, first + b, first + c});
  }
  return all;
}

/// Returns the rotation of a transform that scales first and rotates then. Returns nothing for a
/// transform that mirrors or shears.
std::optional<Eigen::Matrix3d> RotationIn(const Transform& transform) {
  Eigen::Matrix3d rotation = transform.leftCols<3>();
  for (int i = 0; i < 3; ++i) rotation.col(i).normalize();
  const Eigen::Matrix3d square = rotation.transpose() * rotation;
  if (!(rotation.determinant() > 0) || !square.isApprox(Eigen::Matrix3d::Identity(), 1e-6))
    return std::nullopt;
  return rotation;
}

Lying LyingOf(const PrintOrientation& orientation) {
  return {orientation.contact_mm2, orientation.overhang_mm2, orientation.height_mm,
          orientation.stable};
}

}  // namespace

absl::StatusOr<std::optional<OrientationAdvice>> AdviseOrientation(
    std::span<const IndexedMesh* const> parts, const Transform& to_plate,
    const CancelToken& cancel) {
  const std::optional<Eigen::Matrix3d> rotation = RotationIn(to_plate);
  if (!rotation) return std::nullopt;
  const auto suggestion = SuggestOrientation(Together(parts), {.suggestions = 1}, cancel);
  if (!suggestion.ok()) return suggestion.status();
  if (suggestion->best.empty()) return std::nullopt;
  const PrintOrientation& best = suggestion->best.front();
  if (best.score > suggestion->current.score - kLeastGain) return std::nullopt;
  OrientationAdvice advice;
  advice.rotate_deg = AnglesXyzDegrees(best.rotation * *rotation);
  advice.asked = LyingOf(suggestion->current);
  advice.advised = LyingOf(best);
  return advice;
}

}  // namespace slicefarm::slicing
