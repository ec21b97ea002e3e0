#include "services/infill/algo/linking/taken_edge.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/geometry/measure.h"
#include "services/infill/algo/linking/part_beside.h"
#include "services/infill/algo/space_filling/segment_grid.h"

namespace slicefarm::infill {
namespace {

/// Largest length over which a link may overlap another bead, in widths.
constexpr double kMostTaken = 1;
/// Size of the squares in which pieces are indexed, in multiples of the distance that counts as
/// near.
constexpr double kSquares = 8;

struct Segment {
  Point a, b;
  int32_t piece = 0;
};

std::vector<Segment> SegmentsOf(std::span<const Piece> pieces) {
  std::vector<Segment> segments;
  int32_t number = 0;
  for (const Piece& piece : pieces) {
    for (size_t i = 1; i < piece.points.size(); ++i)
      segments.push_back({piece.points[i - 1], piece.points[i], number});
    if (piece.closed) segments.push_back({piece.points.back(), piece.points.front(), number});
    ++number;
  }
  return segments;
}

/// Sorts spans by their start, and joins spans of the same piece that meet.
void Join(double gap_nm, std::vector<TakenSpan>& spans) {
  std::ranges::sort(spans, {},
                    [](const TakenSpan& s) { return std::tuple(s.piece, s.from_nm, s.to_nm); });
  size_t kept = 0;
  for (const TakenSpan& span : spans) {
    if (kept > 0 && span.piece == spans[kept - 1].piece &&
        span.from_nm <= spans[kept - 1].to_nm + gap_nm) {
      spans[kept - 1].to_nm = std::max(spans[kept - 1].to_nm, span.to_nm);
    } else {
      spans[kept++] = span;
    }
  }
  spans.resize(kept);
  std::ranges::stable_sort(spans, {}, &TakenSpan::from_nm);
}

}  // namespace

std::vector<std::vector<TakenSpan>> TakenEdge(const MultiPolygon& region,
                                              std::span<const Piece> pieces, double width_nm) {
  const double near_nm = kLeastApart * width_nm;
  const std::vector<Segment> segments = SegmentsOf(pieces);
  Box box = Bounds(region);
  for (const Segment& segment : segments) box.Add(segment.a), box.Add(segment.b);
  SegmentGrid grid(box, kSquares * near_nm);
  for (size_t i = 0; i < segments.size(); ++i)
    grid.Add(segments[i].a, segments[i].b, static_cast<int32_t>(i));
  std::vector<std::vector<TakenSpan>> taken;
  ForEachRing(region, [&](const Polygon& ring) {
    std::vector<TakenSpan>& spans = taken.emplace_back();
    double at = 0;
    for (size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      const double length = Distance(a, b);
      if (length > 0) {
        grid.ForEachNear(a, b, near_nm, [&](int32_t number) {
          const Segment& segment = segments[static_cast<size_t>(number)];
          if (const auto part = PartBeside(a, b, segment.a, segment.b, near_nm))
            spans.push_back({at + part->from_nm, at + part->to_nm, segment.piece});
        });
      }
      at += length;
    }
    Join(near_nm, spans);
  });
  return taken;
}

TakenRing::TakenRing(std::span<const TakenSpan> taken, double ring_nm)
    : taken_(taken), ring_nm_(ring_nm) {
  farthest_nm_.reserve(taken.size());
  for (const TakenSpan& span : taken)
    farthest_nm_.push_back(farthest_nm_.empty() ? span.to_nm
                                                : std::max(farthest_nm_.back(), span.to_nm));
}

SpanClearance TakenRing::Along(double from_nm, double length_nm, double width_nm) const {
  SpanClearance room{true, length_nm, length_nm};
  for (const double turn : {0.0, ring_nm_}) {
    const double start = from_nm - turn;
    const auto first = std::ranges::upper_bound(farthest_nm_, start) - farthest_nm_.begin();
    for (const TakenSpan& span : taken_.subspan(static_cast<size_t>(first))) {
      if (span.from_nm >= start + length_nm) break;
      if (span.to_nm <= start) continue;
      const double from = std::max(0.0, span.from_nm - start);
      const double to = std::min(length_nm, span.to_nm - start);
      if (to - from > kMostTaken * width_nm) room.links = false;
      room.ahead_nm = std::min(room.ahead_nm, from);
      room.behind_nm = std::min(room.behind_nm, length_nm - to);
    }
  }
  return room;
}

std::vector<double> CornerLengths(const Polygon& ring) {
  std::vector<double> at(1, 0.0);
  at.reserve(ring.size() + 1);
  for (size_t i = 0; i < ring.size(); ++i)
    at.push_back(at.back() + Distance(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]));
  return at;
}

}  // namespace slicefarm::infill
