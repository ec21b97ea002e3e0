#include "services/planning/algo/curl/curled_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/geometry/covers.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/offset.h"
#include "common/geometry/rings/simplify.h"
#include "services/planning/algo/rings/ring_shape.h"

namespace slicefarm::planning {
namespace {

/// Largest distance between sampled points on an outline.
constexpr double kStepNm = 0.5 * kNmPerMm;
/// Length of the outline on either side of a point over which the bend at this point is measured.
/// It is longer than the facets of a round part.
constexpr double kArmNm = 2.0 * kNmPerMm;
/// Range of overhangs that curl up, in widths. A smaller overhang is supported by the layer below,
/// and a larger one sags.
constexpr double kLeastOut = 0.2, kMostOut = 1.1;
/// Radius of curvature at which an overhang of a whole width does not curl up.
constexpr double kStillRadiusNm = 100.0 * kNmPerMm;
/// Distance within which a bead rises with a risen point of the layer below, in widths.
constexpr double kBeside = 3;
/// Height by which a bead presses down a risen layer below it, as a share of the bead's height.
constexpr double kPressed = 0.75;
constexpr double kMostLayers = 10;
/// Smallest rise that travels avoid.
constexpr double kObstacleNm = 0.1 * kNmPerMm;
constexpr Coord kToleranceNm = 50'000;

}  // namespace

/// Index of the risen pieces of a layer, to find the pieces near a point.
class CurledEdges::Places {
 public:
  /// `risen` must outlive this object.
  Places(const std::vector<Risen>& risen, Coord reach_nm) : reach_nm_(reach_nm) {
    for (const Risen& piece : risen) squares_[SquareOf(piece.from)].push_back(&piece);
  }

  /// Returns the largest rise of the pieces within reach of the point; 0 if there are none.
  double MostNear(Point place) const {
    double most = 0;
    const Square square = SquareOf(place);
    for (Coord x = square.first - 1; x <= square.first + 1; ++x)
      for (Coord y = square.second - 1; y <= square.second + 1; ++y) {
        const auto found = squares_.find({x, y});
        if (found == squares_.end()) continue;
        for (const Risen* piece : found->second)
          if (Distance(piece->from, place) <= static_cast<double>(reach_nm_))
            most = std::max(most, piece->rise_nm);
      }
    return most;
  }

 private:
  using Square = std::pair<Coord, Coord>;

  Square SquareOf(Point p) const {
    const auto floor = [&](Coord at) { return at / reach_nm_ - (at % reach_nm_ < 0 ? 1 : 0); };
    return {floor(p.x), floor(p.y)};
  }

  const Coord reach_nm_;
  std::map<Square, std::vector<const Risen*>> squares_;
};

/// Returns the rise of a point from its own overhang, without the rise of the layer below.
double CurledEdges::RiseAt(Point place, double radius_nm) const {
  const auto width = static_cast<double>(width_nm_);
  const auto hit = below_->edges.Nearest(place, std::llround(kMostOut * width));
  if (!hit || hit->inside || hit->distance_nm <= kLeastOut * width) return 0;
  const double squared =
      hit->distance_nm * hit->distance_nm - width * width * radius_nm / kStillRadiusNm;
  return squared > 0 ? std::sqrt(squared) : 0;
}

void CurledEdges::AddRing(const Polygon& ring, const Places& below,
                          const MultiPolygon& above_supports, Coord height_nm,
                          std::vector<Risen>& risen) const {
  const RingShape shape(ring, kArmNm);
  const auto count = static_cast<size_t>(std::max(3.0, std::ceil(shape.length_nm() / kStepNm)));
  std::vector<double> along(count);
  for (size_t i = 0; i < count; ++i)
    along[i] = shape.length_nm() * static_cast<double>(i) / static_cast<double>(count);
  const std::vector<Bend> bends = shape.BendsAt(along);
  const auto height = static_cast<double>(height_nm);
  for (size_t i = 0; i < count; ++i) {
    const Point at = bends[i].at;
    const double pressed = std::max(0.0, below.MostNear(at) - kPressed * height);
    const double turn_rad = bends[i].TurnRad();
    const double own = turn_rad > 0 ? RiseAt(at, shape.arm_nm() / turn_rad) : 0;
    const double rise = std::min(pressed + own, kMostLayers * height);
    if (rise > 0 && !Covers(above_supports, at))
      risen.push_back({at, bends[(i + 1) % count].at, rise});
  }
}

/// Adds the risen pieces of the layer below that are beside the new layer and not under it. Their
/// height above the bed does not change, so their rise decreases by the height of the new layer.
void CurledEdges::KeepUncovered(const RegionEdges& edges, Coord height_nm,
                                std::vector<Risen>& risen) const {
  const auto reach = std::llround(kBeside * static_cast<double>(width_nm_));
  for (const Risen& piece : risen_) {
    const double rise = piece.rise_nm - static_cast<double>(height_nm);
    if (rise <= 0 || edges.Nearest(piece.from, reach) || edges.IsInside(piece.from)) continue;
    risen.push_back({piece.from, piece.to, rise});
  }
}

MultiPolygon CurledEdges::AreaOf(const std::vector<Risen>& risen) const {
  std::vector<Polyline> lines;
  for (const Risen& piece : risen) {
    if (piece.rise_nm <= kObstacleNm || piece.from == piece.to) continue;
    if (!lines.empty() && lines.back().back() == piece.from) {
      lines.back().push_back(piece.to);
    } else {
      lines.push_back({piece.from, piece.to});
    }
  }
  if (lines.empty()) return {};
  const OffsetOptions coarse{.join = Join::kSquare};
  return Simplify(OffsetLines(lines, width_nm_, Cap::kSquare, coarse), kToleranceNm);
}

MultiPolygon CurledEdges::Next(const MultiPolygon& outline, const MultiPolygon& above_supports,
                               Coord height_nm) {
  RegionEdges edges(outline);
  std::vector<Risen> risen;
  if (below_) {
    const Places places(risen_, std::llround(kBeside * static_cast<double>(width_nm_)));
    ForEachRing(outline, [&](const Polygon& ring) {
      AddRing(ring, places, above_supports, height_nm, risen);
    });
    KeepUncovered(edges, height_nm, risen);
  }
  below_.emplace(Below{outline, std::move(edges)});
  risen_ = std::move(risen);
  return AreaOf(risen_);
}

}  // namespace slicefarm::planning
