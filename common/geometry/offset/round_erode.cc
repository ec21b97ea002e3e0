#include "common/geometry/offset/round_erode.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/base/portable_math.h"
#include "common/geometry/boolean/arrangement.h"
#include "common/geometry/offset/swept_curve.h"
#include "common/geometry/vector.h"

namespace slicefarm {
namespace {

using internal::GroupedRing;
using internal::SweptCurve;
using internal::TracedRing;

/// Tolerance of arcs that are only judged.
constexpr double kJudgedArcNm = 5'000;

/// Returns the curves of an island's rings; nullopt if one of them is impossible.
std::optional<std::vector<SweptCurve>> CurvesOf(const PolygonWithHoles& island, Coord distance_nm,
                                                double arc_tolerance) {
  std::vector<SweptCurve> curves;
  const auto append = [&](const Polygon& ring) {
    curves.push_back(internal::SweepInwards(ring, static_cast<double>(distance_nm), arc_tolerance));
    return curves.back().points.size() >= 3;
  };
  if (!append(island.outer) || !std::ranges::all_of(island.holes, append)) return std::nullopt;
  return curves;
}

std::vector<GroupedRing> PointsOf(std::vector<SweptCurve>& curves) {
  std::vector<GroupedRing> rings;
  for (SweptCurve& curve : curves) rings.push_back({std::move(curve.points)});
  return rings;
}

/// Turns along a ring of the outline.
class RingTurns {
 public:
  explicit RingTurns(const Polygon& ring) {
    std::vector<Vector2> edges;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point d = ring[i + 1 == ring.size() ? 0 : i + 1] - ring[i];
      if (d != Point{}) edges.push_back(ToVector(d));
    }
    for (size_t i = 0; i < edges.size(); ++i) {
      const Vector2 &e = edges[i], &f = edges[i + 1 == edges.size() ? 0 : i + 1];
      after_.push_back(Atan2(Cross(e, f), Dot(e, f)));
    }
  }

  /// Returns the greatest turn between two of the edges from `first` to `last`.
  double Greatest(int32_t first, int32_t last) const {
    const auto count = static_cast<int32_t>(after_.size());
    double turn = 0, least = 0, most = 0;
    for (int32_t edge = first; edge != last; edge = edge + 1 == count ? 0 : edge + 1) {
      turn += after_[edge];
      least = std::min(least, turn);
      most = std::max(most, turn);
    }
    return most - least;
  }

 private:
  std::vector<double> after_;  ///< turn to the left after each edge
};

/// Returns true if a ring of the erosion goes around the ring of the outline once, and leaves out
/// only convex corners. `parts`: parts of the outline, in the order of the erosion's edges.
bool GoesAround(const std::vector<int32_t>& parts, int32_t edges, const RingTurns& turns,
                double most_turn) {
  const int32_t count = 2 * edges;
  int64_t total = 0;
  for (size_t i = 0; i < parts.size(); ++i) {
    const int32_t from = parts[i], to = parts[i + 1 == parts.size() ? 0 : i + 1];
    const int32_t step = to >= from ? to - from : to - from + count;
    if (step == 0) continue;
    total += step;
    if (total > count) return false;
    // A corner is the end of one edge and the start of the next one.
    if (turns.Greatest(from / 2, (to + 1) / 2 % edges) >= most_turn) return false;
  }
  return total == count;
}

}  // namespace

std::optional<MultiPolygon> TryRoundErode(const PolygonWithHoles& island, Coord distance_nm,
                                          Coord arc_tolerance_nm) {
  auto curves = CurvesOf(island, distance_nm, static_cast<double>(arc_tolerance_nm));
  if (!curves) return std::nullopt;
  return internal::TryWindingRegion(PointsOf(*curves), 1);
}

Width JudgeWidth(const PolygonWithHoles& island, Coord radius_nm, double most_turn) {
  auto curves = CurvesOf(island, radius_nm, kJudgedArcNm);
  if (!curves) return Width::kUncertain;
  const auto rings = internal::TryWindingRings(PointsOf(*curves), 1);
  if (!rings) return Width::kUncertain;
  if (rings->size() != curves->size()) return Width::kNarrow;
  std::vector<char> seen(curves->size(), false);
  for (const TracedRing& ring : *rings) {
    const int32_t source = ring.edges.front().ring;
    if (seen[source]) return Width::kNarrow;
    seen[source] = true;
    std::vector<int32_t> parts;
    for (const internal::TracedEdge& edge : ring.edges) {
      if (edge.ring != source) return Width::kNarrow;
      parts.push_back((*curves)[source].parts[edge.index]);
    }
    const RingTurns turns(source == 0 ? island.outer : island.holes[source - 1]);
    if (!GoesAround(parts, (*curves)[source].edges, turns, most_turn)) return Width::kNarrow;
  }
  return Width::kWide;
}

}  // namespace slicefarm
