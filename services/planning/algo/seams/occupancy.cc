#include "services/planning/algo/seams/occupancy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "common/base/portable_math.h"
#include "common/geometry/vector.h"
#include "services/planning/algo/rings/ring_shape.h"

namespace slicefarm::planning {
namespace {

constexpr int32_t kMostCells = 256;  // cells along each side
constexpr double kReachMm = 30;
/// Size of the surface patches that share one visibility, in mm.
constexpr int32_t kPatchMm = 4;
/// Largest number of row crossings of an outline, to limit the work. Outlines with more crossings
/// are ignored.
constexpr double kMostCrossings = 20e6;
/// Distance of a ray's start from the middle of the cell, in cells. With this distance the surface
/// in the cell does not hide itself.
constexpr double kLiftCells = 1.5;
constexpr std::array<double, 4> kSideways = {-std::numbers::pi / 3, -std::numbers::pi / 9,
                                             std::numbers::pi / 9, std::numbers::pi / 3};
constexpr std::array<double, 3> kSlopes = {-1, 0, 1};  // dz per horizontal length

Vector2 DirectionOf(double angle_rad) { return {Cos(angle_rad), Sin(angle_rad)}; }

/// Directions of the rays from points with the same outward direction.
struct Rays {
  Vector2 outward;
  std::array<Vector2, kSideways.size()> sideways;
};

const Rays& RaysOf(int outward) {
  static const std::array<Rays, kOutwards> kRays = [] {
    std::array<Rays, kOutwards> rays;
    for (int i = 0; i < kOutwards; ++i) {
      Rays& of = rays[static_cast<size_t>(i)];
      of.outward = DirectionOf(OutwardAngleRad(i));
      for (size_t k = 0; k < kSideways.size(); ++k)
        of.sideways[k] = DirectionOf(OutwardAngleRad(i) + kSideways[k]);
    }
    return rays;
  }();
  return kRays[static_cast<size_t>(outward)];
}

int32_t FloorMm(double nm) { return static_cast<int32_t>(std::floor(nm / kNmPerMm)); }

int32_t FloorDiv(int32_t a, int32_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// Returns the sum of the edges' extents in y, in mm.
double RowsCrossed(const MultiPolygon& outlines) {
  double rows = 0;
  ForEachRing(outlines, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      rows +=
          ToMm(static_cast<double>(std::abs(ring[i + 1 < ring.size() ? i + 1 : 0].y - ring[i].y)));
  });
  return rows;
}

/// Returns the positions where edges of all rings cross the middle line of each millimetre of y, in
/// nm.
std::map<int32_t, std::vector<double>> Crossings(const MultiPolygon& outlines) {
  std::map<int32_t, std::vector<double>> crossings;
  constexpr double kHalf = 0.5 * kNmPerMm;
  const auto add_edge = [&](Point a, Point b) {
    if (a.y > b.y) std::swap(a, b);
    const auto low = static_cast<double>(a.y), high = static_cast<double>(b.y);
    for (int32_t row = FloorMm(low - kHalf); row * 1.0 * kNmPerMm + kHalf < high; ++row) {
      const double y = row * 1.0 * kNmPerMm + kHalf;
      if (y < low) continue;
      const double share = (y - low) / (high - low);
      crossings[row].push_back(static_cast<double>(a.x) + share * static_cast<double>(b.x - a.x));
    }
  };
  ForEachRing(outlines, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      add_edge(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
  });
  return crossings;
}

}  // namespace

void Occupancy::Add(const MultiPolygon& outlines, Coord top_nm) {
  const int32_t slab = FloorMm(static_cast<double>(std::max<Coord>(top_nm - 1, 0)));
  if (slab == last_slab_) return;
  last_slab_ = slab;
  if (RowsCrossed(outlines) > kMostCrossings) return;
  for (auto& [row, places] : Crossings(outlines)) {
    std::ranges::sort(places);
    for (size_t i = 0; i + 1 < places.size(); i += 2) {
      // Takes the cells with their middle inside.
      const int32_t first = FloorMm(places[i] + 0.5 * kNmPerMm);
      const int32_t last = FloorMm(places[i + 1] + 0.5 * kNmPerMm);
      if (first < last) runs_.push_back({slab, row, first, last});
    }
  }
}

void Occupancy::Build() {
  if (runs_.empty()) return;
  Cell most{INT32_MIN, INT32_MIN, 0};
  least_ = {INT32_MAX, INT32_MAX, 0};
  for (const Run& run : runs_) {
    least_ = {std::min(least_.x, run.first), std::min(least_.y, run.row), 0};
    most = {std::max(most.x, run.last), std::max(most.y, run.row + 1),
            std::max(most.z, run.slab + 1)};
  }
  const int32_t extent = std::max({most.x - least_.x, most.y - least_.y, most.z});
  cell_mm_ = (extent + kMostCells - 1) / kMostCells;
  size_ = {(most.x - least_.x) / cell_mm_ + 1, (most.y - least_.y) / cell_mm_ + 1,
           most.z / cell_mm_ + 1};
  const auto cells =
      static_cast<size_t>(size_.x) * static_cast<size_t>(size_.y) * static_cast<size_t>(size_.z);
  solid_.assign(cells / 64 + 1, 0);
  for (const Run& run : runs_) {
    const auto row = (static_cast<size_t>(run.slab / cell_mm_) * static_cast<size_t>(size_.y) +
                      static_cast<size_t>((run.row - least_.y) / cell_mm_)) *
                     static_cast<size_t>(size_.x);
    for (int32_t x = run.first; x < run.last; ++x) {
      const size_t bit = row + static_cast<size_t>((x - least_.x) / cell_mm_);
      solid_[bit / 64] |= uint64_t{1} << (bit % 64);
    }
  }
  seen_.clear();
}

bool Occupancy::IsSolid(Cell cell) const {
  const auto bit =
      (static_cast<size_t>(cell.z) * static_cast<size_t>(size_.y) + static_cast<size_t>(cell.y)) *
          static_cast<size_t>(size_.x) +
      static_cast<size_t>(cell.x);
  return (solid_[bit / 64] >> (bit % 64) & 1) != 0;
}

/// Returns true if a ray leaves the grid, or has 30 mm of free length, without meeting a solid
/// cell. `from` and `step` are in cells.
bool Occupancy::LeadsOut(const double from[3], const double step[3]) const {
  const int steps = static_cast<int>(kReachMm) / cell_mm_;
  for (int i = 0; i <= steps; ++i) {
    const double x = from[0] + i * step[0], y = from[1] + i * step[1], z = from[2] + i * step[2];
    if (x < 0 || y < 0 || z < 0 || x >= size_.x || y >= size_.y || z >= size_.z) return true;
    if (IsSolid({static_cast<int32_t>(x), static_cast<int32_t>(y), static_cast<int32_t>(z)}))
      return false;
  }
  return true;
}

double Occupancy::SeenFrom(Cell cell, int outward) const {
  const Rays& rays = RaysOf(outward);
  const double from[3] = {cell.x + 0.5 + kLiftCells * rays.outward.x(),
                          cell.y + 0.5 + kLiftCells * rays.outward.y(), cell.z + 0.5};
  int seen = 0;
  for (const Vector2& path : rays.sideways) {
    for (const double slope : kSlopes) {
      const double step[3] = {path.x(), path.y(), slope};
      seen += LeadsOut(from, step) ? 1 : 0;
    }
  }
  return seen / static_cast<double>(kSideways.size() * kSlopes.size());
}

double Occupancy::Visibility(Point at, Coord z_nm, int outward) {
  if (solid_.empty()) return 1;
  const Cell cell{FloorDiv(FloorMm(static_cast<double>(at.x)) - least_.x, cell_mm_),
                  FloorDiv(FloorMm(static_cast<double>(at.y)) - least_.y, cell_mm_),
                  FloorMm(static_cast<double>(std::max<Coord>(z_nm - 1, 0))) / cell_mm_};
  // The surface's cells are in the grid or directly beside it.
  const int32_t patch = std::max(kPatchMm / cell_mm_, 1);
  const auto number = static_cast<uint64_t>((cell.x + 1) / patch) +
                      static_cast<uint64_t>((cell.y + 1) / patch) * 1024 +
                      static_cast<uint64_t>(cell.z / patch) * 1024 * 1024;
  const uint64_t key = number * kOutwards + static_cast<uint64_t>(outward);
  const auto [known, is_new] = seen_.try_emplace(key);
  if (is_new) known->second = static_cast<float>(SeenFrom(cell, outward));
  return known->second;
}

}  // namespace slicefarm::planning
