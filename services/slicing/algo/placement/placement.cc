#include "services/slicing/algo/placement/placement.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/placement/rotation.h"
#include "services/slicing/algo/mesh_io/weld.h"

namespace slicefarm::slicing {
namespace {

/// Beyond this, in nm, doubles are no longer exact integers.
constexpr double kRoundable = 9e15;

absl::Status FactorError(std::string_view name, double got) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("{} must be a finite number{}, not {}", name,
                               name == "rotate_deg" ? "" : " above 0", got),
                   {{"setting", std::string(name)}, {"got", fmt::format("{}", got)}});
}

bool IsFactor(double value) { return std::isfinite(value) && value > 0; }

/// From the units of the file to nanometres.
Matrix3 TransformOf(const Placement& placement) {
  Matrix3 transform = RotationXyz(placement.rotate_deg);
  for (auto& row : transform)
    for (int axis = 0; axis < 3; ++axis)
      row[axis] *= placement.unit_mm * placement.scale[axis] * kNmPerMm;
  return transform;
}

std::optional<Coord> Rounded(const std::array<double, 3>& row, const Position& p) {
  const double value = row[0] * p.x + row[1] * p.y + row[2] * p.z;
  if (!(std::abs(value) < kRoundable)) return std::nullopt;
  return std::llround(value);
}

absl::Status RangeError(double got_mm) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                   fmt::format("the placed part reaches {:.3f} mm from the origin, at most {:.3f} "
                               "mm are accepted; are the units right?",
                               got_mm, ToMm(limits::kMaxCoord)),
                   {{"limit", fmt::format("{:.3f}", ToMm(limits::kMaxCoord))},
                    {"got", fmt::format("{:.3f}", got_mm)}});
}

/// Welds what falls onto the same nanometre; the triangles follow.
absl::StatusOr<IndexedMesh> Quantized(const RawMesh& raw, const Matrix3& transform) {
  Welder<Vertex> welder(raw.positions.size());
  std::vector<uint32_t> renumbered;
  renumbered.reserve(raw.positions.size());
  for (const Position& p : raw.positions) {
    const auto x = Rounded(transform[0], p), y = Rounded(transform[1], p),
               z = Rounded(transform[2], p);
    if (!x || !y || !z) return RangeError(kRoundable / kNmPerMm);
    renumbered.push_back(welder.Add({*x, *y, *z}));
  }
  IndexedMesh mesh;
  mesh.triangles = raw.triangles;
  for (auto& triangle : mesh.triangles)
    for (uint32_t& corner : triangle) corner = renumbered[corner];
  mesh.vertices = std::move(welder).TakePoints();
  return mesh;
}

void MoveBy(IndexedMesh& mesh, const Vertex& by) {
  for (Vertex& v : mesh.vertices) v = {v.x + by.x, v.y + by.y, v.z + by.z};
}

/// Rounds down also below zero.
Coord Middle(Coord low, Coord high) { return low + (high - low) / 2; }

}  // namespace

Extent ExtentOf(const IndexedMesh& mesh) {
  Extent extent;
  for (const Vertex& v : mesh.vertices) {
    extent.min = {std::min(extent.min.x, v.x), std::min(extent.min.y, v.y),
                  std::min(extent.min.z, v.z)};
    extent.max = {std::max(extent.max.x, v.x), std::max(extent.max.y, v.y),
                  std::max(extent.max.z, v.z)};
  }
  return extent;
}

absl::Status CheckPlacement(const Placement& placement) {
  if (!IsFactor(placement.unit_mm)) return FactorError("unit_mm", placement.unit_mm);
  for (const double scale : placement.scale)
    if (!IsFactor(scale)) return FactorError("scale", scale);
  for (const double angle : placement.rotate_deg)
    if (!std::isfinite(angle)) return FactorError("rotate_deg", angle);
  return absl::OkStatus();
}

double CoordinateLimit(const Placement& placement) {
  return limits::kMaxMeshCoordinateMm / placement.unit_mm;
}

absl::StatusOr<IndexedMesh> PlaceMesh(const RawMesh& raw, const Placement& placement) {
  if (absl::Status status = CheckPlacement(placement); !status.ok()) return status;
  absl::StatusOr<IndexedMesh> mesh = Quantized(raw, TransformOf(placement));
  if (!mesh.ok()) return mesh;
  const Extent extent = ExtentOf(*mesh);
  MoveBy(*mesh,
         {-Middle(extent.min.x, extent.max.x), -Middle(extent.min.y, extent.max.y), -extent.min.z});
  const Extent placed = ExtentOf(*mesh);
  const Coord reach =
      std::max({placed.max.x, placed.max.y, placed.max.z, -placed.min.x, -placed.min.y});
  if (reach > limits::kMaxCoord) return RangeError(ToMm(static_cast<double>(reach)));
  return mesh;
}

}  // namespace slicefarm::slicing
