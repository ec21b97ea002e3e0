#include "services/slicing/algo/placement/placement.h"

#include <fmt/core.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/weld.h"

namespace slicefarm::slicing {
namespace {

/// Size in nm above which doubles are no longer exact integers.
constexpr double kRoundable = 9e15;

using Row = std::array<double, 4>;

/// Returns a row of the transform, in nm.
Row RowOf(const Transform& transform, int row) {
  return {transform(row, 0) * kNmPerMm, transform(row, 1) * kNmPerMm, transform(row, 2) * kNmPerMm,
          transform(row, 3) * kNmPerMm};
}

std::optional<Coord> Rounded(const Row& row, const Vector3& p) {
  const double value = row[0] * p.x() + row[1] * p.y() + row[2] * p.z() + row[3];
  if (!(std::abs(value) < kRoundable)) return std::nullopt;
  return std::llround(value);
}

absl::Status RangeError(double got_mm) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                   fmt::format("the placed part reaches {:.3f} mm from the origin, at most {:.3f} "
                               "mm are accepted; check the units",
                               got_mm, ToMm(limits::kMaxCoord)),
                   {{"limit", fmt::format("{:.3f}", ToMm(limits::kMaxCoord))},
                    {"got", fmt::format("{:.3f}", got_mm)}});
}

/// Returns the middle, rounded down also for negative values.
Coord Middle(Coord low, Coord high) { return low + (high - low) / 2; }

}  // namespace

absl::StatusOr<IndexedMesh> TransformMesh(const RawMesh& raw, const Transform& transform) {
  const Row row_x = RowOf(transform, 0), row_y = RowOf(transform, 1), row_z = RowOf(transform, 2);
  Welder<Vertex> welder(raw.positions.size());
  std::vector<uint32_t> renumbered;
  renumbered.reserve(raw.positions.size());
  for (const Vector3& p : raw.positions) {
    const auto x = Rounded(row_x, p), y = Rounded(row_y, p), z = Rounded(row_z, p);
    if (!x || !y || !z) return RangeError(kRoundable / kNmPerMm);
    renumbered.push_back(welder.Add({*x, *y, *z}));
  }
  IndexedMesh mesh;
  mesh.triangles = raw.triangles;
  const bool mirrors = transform.leftCols<3>().determinant() < 0;
  for (auto& triangle : mesh.triangles) {
    for (uint32_t& corner : triangle) corner = renumbered[corner];
    if (mirrors) std::swap(triangle[1], triangle[2]);
  }
  mesh.vertices = std::move(welder).TakePoints();
  return mesh;
}

void MoveBy(IndexedMesh& mesh, const Vertex& by) {
  for (Vertex& v : mesh.vertices) v = {v.x + by.x, v.y + by.y, v.z + by.z};
}

Vertex ToOrigin(const Extent& extent, Coord sunk_nm) {
  return {-Middle(extent.min.x, extent.max.x), -Middle(extent.min.y, extent.max.y),
          -extent.min.z - sunk_nm};
}

absl::Status CheckReach(const Extent& extent) {
  const Coord reach = std::max(
      {extent.max.x, extent.max.y, extent.max.z, -extent.min.x, -extent.min.y, -extent.min.z});
  if (reach <= limits::kMaxCoord) return absl::OkStatus();
  return RangeError(ToMm(static_cast<double>(reach)));
}

absl::StatusOr<IndexedMesh> PlaceMesh(const RawMesh& raw, const Transform& transform) {
  absl::StatusOr<IndexedMesh> mesh = TransformMesh(raw, transform);
  if (!mesh.ok()) return mesh;
  MoveBy(*mesh, ToOrigin(ExtentOf(*mesh), 0));
  if (absl::Status reach = CheckReach(ExtentOf(*mesh)); !reach.ok()) return reach;
  return mesh;
}

}  // namespace slicefarm::slicing
