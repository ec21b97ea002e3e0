#include "services/texture/algo/output/displaced_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::texture {
namespace {

static_assert(std::endian::native == std::endian::little, "STL is little-endian");

struct FinePoint {
  Eigen::Vector3d place_mm;
  Eigen::Vector2d map_mm;
  Eigen::Vector3d normal;
  bool border = false;  ///< true on a boundary or a seam
};

using FineFace = std::array<int32_t, 3>;
using FineEdge = std::pair<int32_t, int32_t>;  // the lower number first

FineEdge EdgeOf(int32_t a, int32_t b) { return std::minmax(a, b); }

/// Surface with edges halved until none is longer than requested. Both faces of an edge use the
/// same middle point, so no gap opens.
class Refinement {
 public:
  explicit Refinement(const SurfaceMap& map) : faces_(map.mesh().triangles) {
    for (size_t v = 0; v < map.mesh().points_mm.size(); ++v) {
      const auto vertex = static_cast<int32_t>(v);
      points_.push_back({map.mesh().points_mm[v], map.map_mm()[v], map.VertexNormal(vertex),
                         map.InLoop(vertex).loop >= 0});
    }
    for (const auto& loop : map.loops())
      for (size_t i = 0; i < loop.size(); ++i)
        borders_.insert(EdgeOf(loop[i], loop[(i + 1) % loop.size()]));
  }

  const std::vector<FinePoint>& points() const { return points_; }
  const std::vector<FineFace>& faces() const { return faces_; }

  absl::Status Run(double edge_mm) {
    while (HalveEdges(edge_mm)) {
      std::vector<FineFace> next;
      for (const FineFace& face : faces_) Divide(face, &next);
      faces_ = std::move(next);
      if (static_cast<int64_t>(faces_.size()) > limits::kMaxTriangles)
        return LimitError(Reason::kRequestTooLarge, "triangles of the displaced surface",
                          limits::kMaxTriangles, static_cast<int64_t>(faces_.size()));
    }
    return absl::OkStatus();
  }

 private:
  bool HalveEdges(double edge_mm) {
    middles_.clear();
    for (const FineFace& face : faces_) {
      for (int k = 0; k < 3; ++k) {
        const FineEdge edge = EdgeOf(face[k], face[(k + 1) % 3]);
        if (Length(edge) > edge_mm && !middles_.contains(edge)) middles_[edge] = AddMiddle(edge);
      }
    }
    return !middles_.empty();
  }

  double Length(const FineEdge& edge) const {
    return (points_[edge.first].place_mm - points_[edge.second].place_mm).norm();
  }

  int32_t AddMiddle(const FineEdge& edge) {
    const FinePoint &a = points_[edge.first], &b = points_[edge.second];
    const auto number = static_cast<int32_t>(points_.size());
    const bool border = borders_.contains(edge);
    points_.push_back({(a.place_mm + b.place_mm) / 2, (a.map_mm + b.map_mm) / 2,
                       (a.normal + b.normal).normalized(), border});
    if (border) {
      borders_.insert(EdgeOf(edge.first, number));
      borders_.insert(EdgeOf(edge.second, number));
    }
    return number;
  }

  int32_t MiddleOf(int32_t a, int32_t b) const {
    const auto found = middles_.find(EdgeOf(a, b));
    return found == middles_.end() ? -1 : found->second;
  }

  /// Divides a face into two, three or four faces, by the number of its halved edges.
  void Divide(const FineFace& face, std::vector<FineFace>* next) const {
    std::array<int32_t, 3> middle;
    for (int k = 0; k < 3; ++k) middle[k] = MiddleOf(face[k], face[(k + 1) % 3]);
    const auto count = 3 - std::count(middle.begin(), middle.end(), -1);
    if (count == 0) {
      next->push_back(face);
    } else if (count == 3) {
      for (int k = 0; k < 3; ++k) next->push_back({face[k], middle[k], middle[(k + 2) % 3]});
      next->push_back(middle);
    } else if (count == 1) {
      const int k = middle[0] >= 0 ? 0 : middle[1] >= 0 ? 1 : 2;
      const int32_t opposite = face[(k + 2) % 3];
      next->push_back({face[k], middle[k], opposite});
      next->push_back({middle[k], face[(k + 1) % 3], opposite});
    } else {
      const int k = middle[0] < 0 ? 1 : middle[1] < 0 ? 2 : 0;  // sides k and k + 1 are halved
      const int32_t p = face[k], q = face[(k + 1) % 3], r = face[(k + 2) % 3];
      const int32_t pq = middle[k], qr = middle[(k + 1) % 3];
      next->push_back({pq, q, qr});
      if (Length(EdgeOf(p, qr)) <= Length(EdgeOf(pq, r))) {
        next->push_back({p, pq, qr});
        next->push_back({p, qr, r});
      } else {
        next->push_back({p, pq, r});
        next->push_back({pq, qr, r});
      }
    }
  }

  std::vector<FinePoint> points_;
  std::vector<FineFace> faces_;
  std::set<FineEdge> borders_;
  std::map<FineEdge, int32_t> middles_;
};

/// Checks the number of triangles. No triangle is larger than the equilateral one with the longest
/// edge, which gives a lower limit of their number.
absl::Status CheckSize(const SurfaceMesh& mesh, double edge_mm) {
  double area = 0;
  for (size_t t = 0; t < mesh.triangles.size(); ++t) area += DoubleAreaVector(mesh, t).norm() / 2;
  const double least = area / (edge_mm * edge_mm * std::sqrt(3.0) / 4);
  if (least <= static_cast<double>(limits::kMaxTriangles)) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "triangles of the displaced surface",
                    limits::kMaxTriangles, static_cast<int64_t>(std::min(least, 9e18)));
}

}  // namespace

absl::StatusOr<SurfaceMesh> DisplacedMesh(const EngravePlan& plan,
                                          const DisplacedOptions& options) {
  if (const absl::Status status = CheckSize(plan.map.mesh(), options.edge_mm); !status.ok())
    return status;
  Refinement fine(plan.map);
  if (const absl::Status status = fine.Run(options.edge_mm); !status.ok()) return status;
  std::optional<BoundaryMargin> margin;
  if (plan.options.margin_mm > 0) margin.emplace(plan.map, plan.options.margin_mm);
  const Eigen::Vector2d tile = plan.texture.tile_mm;
  SurfaceMesh mesh;
  mesh.triangles = fine.faces();
  for (const FinePoint& point : fine.points()) {
    const Eigen::Vector2d place = plan.placement.ToTexture(point.map_mm);
    const bool on_tile = plan.placement.repeat ||
                         (place.minCoeff() >= 0 && place.x() <= tile.x() && place.y() <= tile.y());
    const bool masked = plan.mask && plan.mask->heights.At(point.map_mm - plan.map.low_mm()) <
                                         plan.mask->height_mm / 2;
    const bool plain =
        point.border || !on_tile || masked || (margin && !margin->Contains(point.map_mm));
    const double height = plain ? 0 : plan.texture.heights.At(place);
    mesh.points_mm.push_back(point.place_mm +
                             (plan.options.engraved ? -height : height) * point.normal);
  }
  return mesh;
}

std::string StlBytes(const SurfaceMesh& mesh) {
  std::string bytes(80, ' ');
  const auto put = [&bytes](const auto& value) {
    char raw[sizeof(value)];
    std::memcpy(raw, &value, sizeof(value));
    bytes.append(raw, sizeof(value));
  };
  put(static_cast<uint32_t>(mesh.triangles.size()));
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3f normal = DoubleAreaVector(mesh, t).normalized().cast<float>();
    for (const int axis : {0, 1, 2}) put(normal[axis]);
    for (const int32_t vertex : mesh.triangles[t])
      for (const int axis : {0, 1, 2}) put(static_cast<float>(mesh.points_mm[vertex][axis]));
    put(uint16_t{0});
  }
  return bytes;
}

std::string ObjText(const SurfaceMesh& mesh) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  for (const Eigen::Vector3d& p : mesh.points_mm)
    fmt::format_to(out, "v {} {} {}\n", p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : mesh.triangles)
    fmt::format_to(out, "f {} {} {}\n", a + 1, b + 1, c + 1);
  return fmt::to_string(text);
}

}  // namespace slicefarm::texture
