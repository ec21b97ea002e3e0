#include "services/slicing/algo/placement/orientation/orientation.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numbers>
#include <tuple>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/geometry/convex.h"
#include "common/geometry/measure.h"
#include "common/model/scene/rotation.h"
#include "services/slicing/algo/placement/orientation/hull_faces.h"

namespace slicefarm::slicing {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kContactMm = 0.05;
/// Tolerance in degrees, because rounding changes the angle of a face that is exactly at the limit.
constexpr double kDoubtDeg = 0.1;
constexpr size_t kMostCandidates = 40;
/// largest squared difference of normals, or of rotations, that count as equal: about 0.06 degrees
constexpr double kSame = 1e-6;
constexpr double kHeightWeight = 0.25;
constexpr double kContactWeight = 0.25;

/// Mesh in mm, with the values that all candidates need.
struct Body {
  std::vector<Vector3d> vertices;
  /// Normal of each triangle, with the triangle's area as its length.
  std::vector<Vector3d> across;
  std::vector<double> area;
  SpaceHull hull;
  Vector3d mass = Vector3d::Zero();  ///< centre of mass
  double hull_mm2 = 0;
  double size_mm = 0;  ///< square root of the area of the hull's surface
};

Vector3d CenterOfMass(const IndexedMesh& mesh, const Body& body) {
  const Vector3d origin = body.vertices[mesh.triangles[0][0]];
  Vector3d by_volume = Vector3d::Zero(), by_area = Vector3d::Zero();
  double volume = 0, area = 0;
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const Vector3d sum = body.vertices[a] + body.vertices[b] + body.vertices[c] - 3 * origin;
    const double part = body.across[i].dot(body.vertices[a] - origin) / 3;
    volume += part;
    by_volume += part * sum / 4;
    area += body.area[i];
    by_area += body.area[i] * sum / 3;
  }
  const double least = 1e-6 * area * body.size_mm;
  return origin + (volume > least ? Vector3d(by_volume / volume) : Vector3d(by_area / area));
}

Body MakeBody(const IndexedMesh& mesh) {
  Body body;
  body.vertices.reserve(mesh.vertices.size());
  for (const Vertex& v : mesh.vertices) body.vertices.push_back({ToMm(v.x), ToMm(v.y), ToMm(v.z)});
  body.across.reserve(mesh.triangles.size());
  body.area.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vector3d& at = body.vertices[a];
    body.across.push_back((body.vertices[b] - at).cross(body.vertices[c] - at) / 2);
    body.area.push_back(body.across.back().norm());
  }
  return body;
}

/// Returns the mesh without the vertices that no triangle uses, because they are no part of the
/// object.
IndexedMesh Compacted(const IndexedMesh& mesh) {
  std::vector<uint32_t> index(mesh.vertices.size(), UINT32_MAX);
  for (const auto& triangle : mesh.triangles)
    for (const uint32_t v : triangle) index[v] = 0;
  IndexedMesh compact;
  for (size_t i = 0; i < index.size(); ++i) {
    if (index[i] == UINT32_MAX) continue;
    index[i] = static_cast<uint32_t>(compact.vertices.size());
    compact.vertices.push_back(mesh.vertices[i]);
  }
  compact.triangles = mesh.triangles;
  for (auto& triangle : compact.triangles)
    for (uint32_t& v : triangle) v = index[v];
  return compact;
}

void Measure(const IndexedMesh& mesh, Body& body) {
  body.hull = HullOf(mesh.vertices);
  for (const SpaceHull::Face& face : body.hull.faces) body.hull_mm2 += face.area_mm2;
  body.size_mm = std::sqrt(body.hull_mm2);
  body.mass = CenterOfMass(mesh, body);
}

/// Candidate directions for pointing down. Each has the total area of the faces with this normal.
class Directions {
 public:
  /// Adds a face. `across`: its normal, with the area as its length.
  void Add(const Vector3d& across, double area) {
    if (area <= 0) return;
    const Vector3d normal = across / area;
    Bin& bin = bins_[Key(normal)];
    bin.area += area;
    if (area <= bin.largest) return;
    bin.largest = area;
    bin.normal = normal;
  }

  std::vector<Vector3d> Largest(size_t count) const {
    std::vector<std::pair<double, std::array<int, 3>>> order;
    for (const auto& [key, bin] : bins_) order.push_back({-bin.area, key});
    std::sort(order.begin(), order.end());
    if (order.size() > count) order.resize(count);
    std::vector<Vector3d> normals;
    for (const auto& [area, key] : order) normals.push_back(bins_.at(key).normal);
    return normals;
  }

 private:
  struct Bin {
    double area = 0, largest = 0;
    Vector3d normal;  ///< normal of the largest face
  };
  static std::array<int, 3> Key(const Vector3d& normal) {
    const auto part = [](double v) { return static_cast<int>(std::lround(v * 50)); };
    return {part(normal.x()), part(normal.y()), part(normal.z())};
  }
  std::map<std::array<int, 3>, Bin> bins_;
};

/// Returns the smallest rotation after which `normal` points down, computed with + - * / only.
Matrix3d TurnedDown(const Vector3d& normal) {
  if (normal.z() < -1 + 1e-12) return Matrix3d::Identity();
  if (normal.z() > 1 - 1e-12) return Vector3d(1, -1, -1).asDiagonal();
  const Vector3d axis = normal.cross(-Vector3d::UnitZ());  // its length is the sine of the angle
  Matrix3d k;
  k << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
  return Matrix3d::Identity() + k + k * k / (1 - normal.z());
}

std::vector<Matrix3d> Candidates(const Body& body) {
  Directions of_hull, of_mesh;
  for (const SpaceHull::Face& face : body.hull.faces)
    of_hull.Add(face.normal * face.area_mm2, face.area_mm2);
  for (size_t i = 0; i < body.area.size(); ++i) of_mesh.Add(body.across[i], body.area[i]);
  std::vector<Vector3d> normals = of_hull.Largest(kMostCandidates / 2);
  for (const Vector3d& normal : of_mesh.Largest(kMostCandidates / 2)) {
    const bool known = std::any_of(normals.begin(), normals.end(), [&](const Vector3d& other) {
      return (normal - other).squaredNorm() < kSame;
    });
    if (!known) normals.push_back(normal);
  }
  std::vector<Matrix3d> rotations = {Matrix3d::Identity()};
  for (const Vector3d& normal : normals)
    if (Matrix3d rotation = TurnedDown(normal); rotation != rotations[0])
      rotations.push_back(std::move(rotation));
  return rotations;
}

Point OnBed(const Vector3d& v) { return {FromMm(v.x()), FromMm(v.y())}; }

/// Heights of all vertices above the bed, and the hull of the vertices that touch the bed.
struct Stand {
  std::vector<double> height;
  Polygon base;
  double top = 0;
};

Stand StandOf(const Body& body, const Matrix3d& rotation) {
  const Vector3d up = rotation.row(2);
  double bottom = std::numeric_limits<double>::infinity(), top = -bottom;
  for (const Vector3d& corner : body.hull.corners) {
    bottom = std::min(bottom, up.dot(corner));
    top = std::max(top, up.dot(corner));
  }
  Stand stand;
  stand.top = top - bottom;
  stand.height.reserve(body.vertices.size());
  for (const Vector3d& v : body.vertices) stand.height.push_back(up.dot(v) - bottom);
  std::vector<Point> touching;
  for (size_t v = 0; v < body.vertices.size(); ++v)
    if (stand.height[v] <= kContactMm) touching.push_back(OnBed(rotation * body.vertices[v]));
  stand.base = ConvexHull(std::move(touching));
  return stand;
}

void AddFaces(const IndexedMesh& mesh, const Body& body, const Stand& stand,
              const OrientationOptions& options, PrintOrientation& result) {
  const Vector3d up = result.rotation.row(2);
  const double steep = SineCosineDegrees(std::max(0.0, options.overhang_deg - kDoubtDeg)).cosine;
  for (size_t i = 0; i < body.area.size(); ++i) {
    const double down = -up.dot(body.across[i]);
    if (down <= 0) continue;
    const auto& [a, b, c] = mesh.triangles[i];
    const double highest = std::max({stand.height[a], stand.height[b], stand.height[c]});
    if (highest <= kContactMm)
      result.contact_mm2 += down;
    else if (down > steep * body.area[i])
      result.overhang_mm2 += down;
  }
}

/// Returns an orientation with all measures except the areas of faces, which are the most
/// expensive.
PrintOrientation Measured(const Body& body, const Stand& stand, const Matrix3d& rotation) {
  PrintOrientation result;
  result.rotation = rotation;
  result.height_mm = stand.top;
  result.stable = StrictlyInside(OnBed(rotation * body.mass), stand.base);
  std::vector<Point> seen;
  for (const Vector3d& corner : body.hull.corners) seen.push_back(OnBed(rotation * corner));
  result.footprint_mm2 = SignedArea(ConvexHull(std::move(seen))) / kNmPerMm / kNmPerMm;
  return result;
}

PrintOrientation Judged(const IndexedMesh& mesh, const Body& body, const Stand& stand,
                        PrintOrientation result, const OrientationOptions& options) {
  AddFaces(mesh, body, stand, options, result);
  result.score = (result.overhang_mm2 - kContactWeight * result.contact_mm2) / body.hull_mm2 +
                 kHeightWeight * result.height_mm / body.size_mm + (result.stable ? 0 : 1);
  return result;
}

absl::Status CheckOptions(const OrientationOptions& options) {
  if (options.overhang_deg >= 0 && options.overhang_deg <= 90) return absl::OkStatus();
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   "the overhang's angle must be from 0 to 90 degrees",
                   {{"setting", "overhang_deg"}});
}

/// Returns the `count` orientations with the lowest scores, in ascending order, each one once. The
/// input contains the current orientation twice if the object already rests on a face.
std::vector<PrintOrientation> Ranked(std::vector<PrintOrientation> all, size_t count) {
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& a, const auto& b) { return a.score < b.score; });
  std::vector<PrintOrientation> ranked;
  for (const PrintOrientation& next : all) {
    const bool known = std::any_of(ranked.begin(), ranked.end(), [&](const auto& other) {
      return (next.rotation - other.rotation).squaredNorm() < kSame;
    });
    if (!known && ranked.size() < count) ranked.push_back(next);
  }
  return ranked;
}

}  // namespace

absl::StatusOr<OrientationSuggestion> SuggestOrientation(const IndexedMesh& given,
                                                         const OrientationOptions& options,
                                                         const CancelToken& cancel) {
  if (absl::Status status = CheckOptions(options); !status.ok()) return status;
  const IndexedMesh mesh = Compacted(given);
  Body body = MakeBody(mesh);
  if (std::all_of(body.area.begin(), body.area.end(), [](double area) { return area == 0; }))
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshEmpty,
                     "no triangle has an area");
  Measure(mesh, body);
  OrientationSuggestion suggestion;
  std::vector<PrintOrientation> stable;
  for (const Matrix3d& rotation : Candidates(body)) {
    if (absl::Status status = cancel.Check(); !status.ok()) return status;
    const Stand stand = StandOf(body, rotation);
    PrintOrientation candidate = Measured(body, stand, rotation);
    const bool current = rotation == Matrix3d::Identity();
    if (!candidate.stable && !current) continue;
    candidate = Judged(mesh, body, stand, std::move(candidate), options);
    if (candidate.stable) stable.push_back(candidate);
    if (current) suggestion.current = std::move(candidate);
  }
  suggestion.best = Ranked(std::move(stable), options.suggestions);
  return suggestion;
}

std::array<double, 3> AnglesXyzDegrees(const Matrix3d& rotation) {
  // The rotation is Rz Ry Rx; its last row is (-sin y, cos y sin x, cos y cos x).
  const auto degrees = [](double sine, double cosine) {
    return std::round(Atan2(sine, cosine) * 180e6 / std::numbers::pi) / 1e6 + 0.0;
  };
  const double cosine_y = Hypot(rotation(0, 0), rotation(1, 0));
  const double y = degrees(-rotation(2, 0), cosine_y);
  if (cosine_y > 1e-9)
    return {degrees(rotation(2, 1), rotation(2, 2)), y, degrees(rotation(1, 0), rotation(0, 0))};
  return {0, y, degrees(-rotation(0, 1), rotation(1, 1))};
}

}  // namespace slicefarm::slicing
