#include "services/texture/algo/pattern/texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::texture {
namespace {

constexpr double kFoot = -1;      // depth of walls below the base, in units of the height
constexpr int32_t kRaster = 256;  // nodes along a side of a solid's height grid

absl::Status NoHeight() {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kNothingToPrint,
                   "the texture has no height");
}

absl::Status CheckSolid(const SurfaceMesh& solid) {
  if (solid.triangles.empty())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "the texture has no triangles");
  for (const Eigen::Vector3d& p : solid.points_mm)
    if (!p.allFinite())
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshNotFinite,
                       "the texture has a coordinate that is not a number");
  const auto points = static_cast<int32_t>(solid.points_mm.size());
  for (const auto& triangle : solid.triangles)
    for (const int32_t vertex : triangle)
      if (vertex < 0 || vertex >= points)
        return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshMalformed,
                         "a triangle of the texture refers to a vertex that does not exist");
  return absl::OkStatus();
}

/// Adds the upper faces, two for each cell, on (columns + 1) * (rows + 1) points.
void AddUpperFaces(const HeightGrid& heights, SurfaceMesh* solid) {
  const int32_t across = heights.columns + 1;
  for (int32_t row = 0; row <= heights.rows; ++row) {
    for (int32_t column = 0; column <= heights.columns; ++column) {
      const Eigen::Vector2d p = heights.NodePosition(column, row);
      solid->points_mm.push_back({p.x(), p.y(), heights.NodeMm(column, row)});
    }
  }
  for (int32_t row = 0; row < heights.rows; ++row) {
    for (int32_t column = 0; column < heights.columns; ++column) {
      const int32_t p00 = row * across + column;
      const int32_t p10 = p00 + 1, p01 = p00 + across, p11 = p01 + 1;
      if (heights.CutFromNode(column, row)) {
        solid->triangles.push_back({p00, p10, p11});
        solid->triangles.push_back({p00, p11, p01});
      } else {
        solid->triangles.push_back({p00, p10, p01});
        solid->triangles.push_back({p10, p11, p01});
      }
    }
  }
}

/// Adds walls from the border of the upper faces downwards.
void AddWalls(const HeightGrid& heights, double foot_mm, SurfaceMesh* solid) {
  const int32_t across = heights.columns + 1;
  std::vector<int32_t> border;  // counter-clockwise
  for (int32_t i = 0; i < heights.columns; ++i) border.push_back(i);
  for (int32_t k = 0; k < heights.rows; ++k) border.push_back(k * across + heights.columns);
  for (int32_t i = heights.columns; i > 0; --i) border.push_back(heights.rows * across + i);
  for (int32_t k = heights.rows; k > 0; --k) border.push_back(k * across);
  const auto first = static_cast<int32_t>(solid->points_mm.size());
  for (const int32_t vertex : border) {
    const Eigen::Vector3d p = solid->points_mm[vertex];
    solid->points_mm.push_back({p.x(), p.y(), foot_mm});
  }
  const auto count = static_cast<int32_t>(border.size());
  for (int32_t i = 0; i < count; ++i) {
    const int32_t next = (i + 1) % count;
    solid->triangles.push_back({first + i, first + next, border[next]});
    solid->triangles.push_back({first + i, border[next], border[i]});
  }
}

/// Raises the nodes below a triangle to the triangle's height.
void Rasterize(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
               HeightGrid* grid) {
  const Eigen::Vector2d cell(grid->size_mm.x() / grid->columns, grid->size_mm.y() / grid->rows);
  const double area = (b - a).head<2>().x() * (c - a).y() - (b - a).y() * (c - a).x();
  if (area == 0) return;
  const Eigen::Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const auto from = [&](int axis) {
    return std::max(0, static_cast<int32_t>(std::ceil(low[axis] / cell[axis])));
  };
  const auto to = [&](int axis, int32_t count) {
    return std::min(count - 1, static_cast<int32_t>(std::floor(high[axis] / cell[axis])));
  };
  for (int32_t row = from(1); row <= to(1, grid->rows); ++row) {
    for (int32_t column = from(0); column <= to(0, grid->columns); ++column) {
      const Eigen::Vector2d p(column * cell.x(), row * cell.y());
      const double wb =
          ((p.x() - a.x()) * (c.y() - a.y()) - (p.y() - a.y()) * (c.x() - a.x())) / area;
      const double wc =
          ((b.x() - a.x()) * (p.y() - a.y()) - (b.y() - a.y()) * (p.x() - a.x())) / area;
      if (wb < 0 || wc < 0 || wb + wc > 1) continue;
      double& height = grid->heights_mm[static_cast<size_t>(row) * grid->columns + column];
      height = std::max(height, a.z() + wb * (b.z() - a.z()) + wc * (c.z() - a.z()));
    }
  }
}

HeightGrid UpperSideOf(const SurfaceMesh& solid, const Eigen::Vector2d& size_mm) {
  HeightGrid grid{kRaster, kRaster, size_mm, std::vector<double>(kRaster * kRaster, 0.0)};
  for (const auto& [a, b, c] : solid.triangles)
    Rasterize(solid.points_mm[a], solid.points_mm[b], solid.points_mm[c], &grid);
  return grid;
}

}  // namespace

absl::StatusOr<Texture> TextureOf(HeightGrid heights) {
  Texture texture;
  texture.tile_mm = heights.size_mm;
  texture.height_mm = *std::max_element(heights.heights_mm.begin(), heights.heights_mm.end());
  if (!(texture.height_mm > 0)) return NoHeight();
  AddUpperFaces(heights, &texture.solid);
  AddWalls(heights, kFoot * texture.height_mm, &texture.solid);
  texture.heights = std::move(heights);
  return texture;
}

absl::StatusOr<Texture> TextureOf(SurfaceMesh solid, const Eigen::Vector2d& pitch_mm) {
  if (const absl::Status status = CheckSolid(solid); !status.ok()) return status;
  Eigen::Vector3d low = solid.points_mm[solid.triangles[0][0]], high = low;
  for (const auto& triangle : solid.triangles) {
    for (const int32_t vertex : triangle) {
      low = low.cwiseMin(solid.points_mm[vertex]);
      high = high.cwiseMax(solid.points_mm[vertex]);
    }
  }
  const Eigen::Vector3d size = high - low;
  if (!(size.minCoeff() > 0)) return NoHeight();
  Texture texture;
  for (int axis = 0; axis < 2; ++axis) {
    texture.tile_mm[axis] = pitch_mm[axis] > 0 ? pitch_mm[axis] : size[axis];
    if (texture.tile_mm[axis] < size[axis])
      return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                       fmt::format("the texture's pitch, {} mm, is less than its size, {} mm",
                                   pitch_mm[axis], size[axis]),
                       {{"setting", "texture_pitch"}});
  }
  texture.height_mm = size.z();
  for (Eigen::Vector3d& p : solid.points_mm) p -= low;
  texture.heights = UpperSideOf(solid, texture.tile_mm);
  texture.solid = std::move(solid);
  return texture;
}

}  // namespace slicefarm::texture
