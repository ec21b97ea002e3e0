#include "services/infill/algo/linking/lifted_ends.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "common/geometry/measure.h"
#include "services/infill/algo/lines/shortened.h"

namespace slicefarm::infill {
namespace {

/// Smallest length of a piece's end beside the boundary, in widths. A shorter end is a turn.
constexpr double kLeastLift = 0.7;
/// Largest part of a piece that may be removed at each end.
constexpr double kMostLift = 0.4;

class Lifter {
 public:
  Lifter(const MultiPolygon& region, std::span<const Piece> pieces, double width_nm)
      : width_nm_(width_nm) {
    lifted_.pieces.assign(pieces.begin(), pieces.end());
    lifted_.taken = TakenEdge(region, pieces, width_nm);
    ForEachRing(region, [this](const Polygon& ring) {
      rings_.push_back(&ring);
      corner_at_.push_back(CornerLengths(ring));
    });
    for (const std::vector<TakenSpan>& taken : lifted_.taken) {
      std::vector<size_t>& order = by_piece_.emplace_back(taken.size());
      std::iota(order.begin(), order.end(), size_t{0});
      std::ranges::stable_sort(order, {}, [&](size_t i) { return taken[i].piece; });
      freed_.emplace_back(taken.size(), false);
    }
  }

  LiftedPieces Run() {
    for (size_t i = 0; i < lifted_.pieces.size(); ++i) {
      Piece& piece = lifted_.pieces[i];
      if (piece.closed) continue;
      const double length = Length(piece.points);
      const Foot from = Lift(piece.from, piece.points.front(), static_cast<int32_t>(i), length);
      const Foot to = Lift(piece.to, piece.points.back(), static_cast<int32_t>(i), length);
      if (from.lifted_nm + to.lifted_nm <= 0) continue;
      piece.points = Shortened(piece.points, length, from.lifted_nm, to.lifted_nm);
      if (from.lifted_nm > 0) {
        piece.points.insert(piece.points.begin(), from.at);
        piece.from = from.place;
      }
      if (to.lifted_nm > 0) {
        piece.points.push_back(to.at);
        piece.to = to.place;
      }
    }
    EraseFreed();
    return std::move(lifted_);
  }

 private:
  /// Position where a lifted piece meets the boundary.
  struct Foot {
    double lifted_nm = 0;
    Point at;
    EdgePosition place;
  };

  /// Returns the new foot of an end. The end is not lifted if the piece is beside the boundary on
  /// both sides of the end, or over too great a length.
  Foot Lift(EdgePosition place, Point end, int32_t piece, double length_nm) {
    if (place.ring < 0) return {};
    const auto ring = static_cast<size_t>(place.ring);
    const Polygon& points = *rings_[ring];
    const double along = corner_at_[ring][static_cast<size_t>(place.edge)] +
                         Distance(points[static_cast<size_t>(place.edge)], end);
    const double touching = width_nm_ / 4;
    const std::optional<size_t> found = TakenAt(ring, along, touching, piece);
    if (!found) return {};
    const TakenSpan* span = &lifted_.taken[ring][*found];
    const double ahead = span->to_nm - along, behind = along - span->from_nm;
    const double lift = std::max(ahead, behind);
    if (lift < kLeastLift * width_nm_ || lift > kMostLift * length_nm ||
        std::min(ahead, behind) > touching)
      return {};
    freed_[ring][*found] = true;
    return FootAt(ring, along + (ahead > behind ? ahead : -behind), lift);
  }

  /// Returns the index of the first part of a ring that a piece still takes near a place.
  std::optional<size_t> TakenAt(size_t ring, double along_nm, double touching_nm,
                                int32_t piece) const {
    const std::vector<TakenSpan>& taken = lifted_.taken[ring];
    const std::vector<size_t>& order = by_piece_[ring];
    auto i = std::ranges::lower_bound(order, piece, {}, [&](size_t k) { return taken[k].piece; });
    for (; i != order.end() && taken[*i].piece == piece; ++i)
      if (!freed_[ring][*i] && taken[*i].from_nm <= along_nm + touching_nm &&
          taken[*i].to_nm >= along_nm - touching_nm)
        return *i;
    return std::nullopt;
  }

  /// Erases the parts of rings that lifted ends no longer take.
  void EraseFreed() {
    for (size_t ring = 0; ring < freed_.size(); ++ring) {
      std::vector<TakenSpan> left;
      for (size_t i = 0; i < freed_[ring].size(); ++i)
        if (!freed_[ring][i]) left.push_back(lifted_.taken[ring][i]);
      lifted_.taken[ring] = std::move(left);
    }
  }

  Foot FootAt(size_t ring, double along_nm, double lifted_nm) const {
    const std::vector<double>& corners = corner_at_[ring];
    const Polygon& points = *rings_[ring];
    const auto next = std::upper_bound(corners.begin() + 1, corners.end() - 1, along_nm);
    const auto edge = static_cast<size_t>(next - corners.begin()) - 1;
    const Point a = points[edge], b = points[edge + 1 == points.size() ? 0 : edge + 1];
    const double length = corners[edge + 1] - corners[edge];
    const double share = length > 0 ? std::clamp((along_nm - corners[edge]) / length, 0.0, 1.0) : 0;
    return {lifted_nm,
            {a.x + std::llround(share * static_cast<double>(b.x - a.x)),
             a.y + std::llround(share * static_cast<double>(b.y - a.y))},
            {static_cast<int32_t>(ring), static_cast<int32_t>(edge)}};
  }

  double width_nm_;
  LiftedPieces lifted_;
  std::vector<const Polygon*> rings_;
  std::vector<std::vector<double>> corner_at_;
  /// indices of each ring's taken parts, sorted by piece
  std::vector<std::vector<size_t>> by_piece_;
  std::vector<std::vector<bool>> freed_;  ///< parts of each ring that are no longer taken
};

}  // namespace

LiftedPieces LiftEnds(const MultiPolygon& region, std::span<const Piece> pieces, Coord width_nm) {
  return Lifter(region, pieces, static_cast<double>(width_nm)).Run();
}

}  // namespace slicefarm::infill
