#include "services/exposure/algo/decompose/decompose.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"
#include "common/geometry/measure.h"
#include "common/geometry/predicates.h"
#include "services/exposure/algo/decompose/cgal_partition.h"
#include "services/exposure/algo/decompose/cut_region.h"
#include "services/exposure/algo/decompose/exact_vector.h"
#include "services/exposure/algo/decompose/link_choice.h"
#include "services/exposure/algo/decompose/mended_rings.h"
#include "services/exposure/algo/decompose/merge_corners.h"

namespace slicefarm::exposure {
namespace {

/// largest share of the area that the removal of corners may change
constexpr double kKeptArea = 2e-10;
constexpr Coord kMaxScale = 1'000'000;  ///< more than 1,000,000 steps per nanometre are not useful

Coord Extent(const MultiPolygon& islands) {
  Coord extent = 1;
  ForEachRing(islands, [&](const Polygon& ring) {
    for (const Point p : ring) extent = std::max({extent, std::abs(p.x), std::abs(p.y)});
  });
  return extent;
}

/// Returns the greatest power of ten by which the coordinates can be scaled.
Coord ScaleFor(const MultiPolygon& islands) {
  const Coord extent = Extent(islands);
  Coord scale = 1;
  while (scale < kMaxScale && extent <= kExactCoord / (10 * scale)) scale *= 10;
  return scale;
}

MultiPolygon Scaled(MultiPolygon islands, Coord scale) {
  const auto apply = [scale](Polygon& ring) {
    for (Point& p : ring) p = {p.x * scale, p.y * scale};
  };
  for (PolygonWithHoles& island : islands) {
    apply(island.outer);
    for (Polygon& hole : island.holes) apply(hole);
  }
  return islands;
}

double Degrees(double cosine) { return Acos(cosine) * 180 / std::numbers::pi; }

absl::Status CannotCut(Point p, Coord scale) {
  return MakeError(
      absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
      fmt::format("the outline cannot be cut at ({:.6f}, {:.6f}) mm: its rings cross or "
                  "overlap",
                  ToMm(static_cast<double>(p.x) / static_cast<double>(scale)),
                  ToMm(static_cast<double>(p.y) / static_cast<double>(scale))),
      {{"x_nm", std::to_string(p.x / scale)}, {"y_nm", std::to_string(p.y / scale)}});
}

/// Looks for a point that the outer ring passes twice. Returns the next reflex corner between the
/// two visits; a cut from this corner separates them. Returns nullopt if no point is passed twice.
std::optional<CornerIndex> InsideRepeat(const CutRegion& region) {
  const Polygon& ring = region.rings[0];
  std::vector<size_t> order(ring.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::sort(order.begin(), order.end(),
            [&](size_t a, size_t b) { return std::tuple(ring[a], a) < std::tuple(ring[b], b); });
  std::optional<std::pair<size_t, size_t>> least;
  for (size_t k = 1; k < order.size(); ++k) {
    if (ring[order[k]] != ring[order[k - 1]]) continue;
    if (!least || order[k] - order[k - 1] < least->second - least->first)
      least = {order[k - 1], order[k]};
  }
  if (!least) return std::nullopt;
  const auto inside = FirstReflex(region, {0, least->first + 1});
  return inside && inside->ring == 0 ? inside : FirstReflex(region);
}

/// Decomposition of regions: cuts each region until all its parts are finished.
class Cutter {
 public:
  Cutter(const DecomposeOptions& options, const CancelToken& cancel, ConvexPieces& result)
      : options_(options), cancel_(cancel), result_(result) {}

  absl::Status Cut(CutRegion island) {
    method_ = options_.method;
    if (absl::Status status = CutAll(std::move(island)); !status.ok()) return status;
    // Bian's method cuts the regions that the requested method could not cut.
    method_ = DecomposeMethod::kBian;
    for (CutRegion& region : std::exchange(left_, {}))
      if (absl::Status status = CutAll(std::move(region)); !status.ok()) return status;
    return absl::OkStatus();
  }

 private:
  absl::Status CutAll(CutRegion island) {
    std::vector<CutRegion> open;
    open.push_back(std::move(island));
    while (!open.empty()) {
      CutRegion region = std::move(open.back());
      open.pop_back();
      const std::optional<CornerIndex> corner = NextCorner(region);
      if (!corner) {
        Finish(std::move(region));
        continue;
      }
      if (absl::Status status = cancel_.Check(); !status.ok()) return status;
      const std::optional<Link> link = choice_.Choose(region, *corner, options_.variant);
      if (!link) return CannotCut(region.rings[corner->ring][corner->point], result_.scale);
      std::vector<CutRegion> parts = Apply(std::move(region), *corner, *link);
      std::move(parts.rbegin(), parts.rend(), std::back_inserter(open));
    }
    return absl::OkStatus();
  }

  /// Returns the corner of the next cut, or nullopt if the region can be finished.
  std::optional<CornerIndex> NextCorner(const CutRegion& region) const {
    if (method_ == DecomposeMethod::kBian) return FirstReflex(region);
    if (region.rings.size() > 1) return FirstReflex(region, {1, 0});
    return InsideRepeat(region);
  }

  std::vector<CutRegion> Apply(CutRegion region, CornerIndex corner, const Link& link) {
    CornerIndex end = link.end;
    if (link.extra) {
      Polygon& ring = region.rings[end.ring];
      ring.insert(ring.begin() + static_cast<ptrdiff_t>(end.point) + 1, *link.extra);
      ++end.point;
      if (corner.ring == end.ring && corner.point >= end.point) ++corner.point;
      ++result_.counts.extra_points;
    }
    if (link.cosine > kCosine30) ++result_.counts.sharp_cuts;
    greatest_cosine_ = std::max(greatest_cosine_, link.cosine);
    result_.min_cut_angle_deg = Degrees(greatest_cosine_);
    if (link.ruled_cosine) {
      ++result_.ruled_cuts;
      result_.min_ruled_angle_deg =
          std::min(result_.min_ruled_angle_deg, Degrees(*link.ruled_cosine));
    }
    return CutAlong(std::move(region), corner, end);
  }

  void Finish(CutRegion region) {
    Polygon& ring = region.rings[0];
    if (method_ == DecomposeMethod::kBian) {
      result_.pieces.push_back(std::move(ring));
    } else if (auto pieces = CgalPartition(ring, method_)) {
      std::move(pieces->begin(), pieces->end(), std::back_inserter(result_.pieces));
    } else {
      ++result_.counts.replaced;
      left_.push_back(std::move(region));
    }
  }

  const DecomposeOptions& options_;
  const CancelToken& cancel_;
  ConvexPieces& result_;
  DecomposeMethod method_ = DecomposeMethod::kBian;  ///< method of the current pass
  /// regions that the requested method could not cut; Bian's method cuts them
  std::vector<CutRegion> left_;
  LinkChoice choice_;
  double greatest_cosine_ = -1;
};

/// Rotates the points of each ring, so that the search for cuts begins at other corners. The shift
/// is `variant` times about the golden share (0.618) of the ring.
void TurnRings(MultiPolygon& islands, int32_t variant) {
  const auto turn = [variant](Polygon& ring) {
    const auto size = static_cast<int64_t>(ring.size());
    std::rotate(ring.begin(), ring.begin() + (variant * (size * 5 / 13 + 1)) % size, ring.end());
  };
  for (PolygonWithHoles& island : islands) {
    turn(island.outer);
    for (Polygon& hole : island.holes) turn(hole);
  }
}

int64_t ReflexCount(const MultiPolygon& islands) {
  int64_t count = 0;
  ForEachRing(islands, [&](const Polygon& ring) {
    for (size_t i = 0; i < ring.size(); ++i)
      count += Orientation(Before(ring, i), ring[i], After(ring, i)) < 0 ? 1 : 0;
  });
  return count;
}

}  // namespace

absl::StatusOr<ConvexPieces> Decompose(const MultiPolygon& islands, const DecomposeOptions& options,
                                       const CancelToken& cancel) {
  auto mended = MendedRings(islands);
  if (!mended.ok()) return mended.status();
  ConvexPieces result;
  result.scale = ScaleFor(islands);
  const double scale = static_cast<double>(result.scale);
  const double area = Area(islands) * scale * scale;
  MultiPolygon merged =
      MergeCorners(Scaled(*std::move(mended), result.scale),
                   {.sagitta = options.merge_nm * scale, .area = kKeptArea * area});
  if (options.variant > 0) TurnRings(merged, options.variant);
  result.counts.reflex = ReflexCount(merged);
  Cutter cutter(options, cancel, result);
  for (const PolygonWithHoles& island : merged) {
    CutRegion region{{island.outer}};
    region.rings.insert(region.rings.end(), island.holes.begin(), island.holes.end());
    if (absl::Status status = cutter.Cut(std::move(region)); !status.ok()) return status;
  }
  result.counts.pieces = std::ssize(result.pieces);
  return result;
}

}  // namespace slicefarm::exposure
