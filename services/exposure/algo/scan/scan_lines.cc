#include "services/exposure/algo/scan/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::exposure {
namespace {

/// Edge of a region in the coordinates u, v of the lines, from its lower end to its upper end. It
/// meets the lines [first, last).
struct FrameEdge {
  double u = 0, v = 0;  ///< lower end of the edge
  double slope = 0;     ///< du / dv
  int64_t first = 0, last = 0;
};

std::vector<FrameEdge> FrameEdges(const MultiPolygon& region, const LineAxes& frame,
                                  const LineGrid& grid) {
  std::vector<FrameEdge> edges;
  edges.reserve(PointCount(region));
  const auto line_at = [&](double v) {
    return static_cast<int64_t>(std::ceil(v / grid.pitch_nm - grid.phase));
  };
  ForEachRing(region, [&](const Polygon& ring) {
    if (ring.empty()) return;
    double u = frame.U(ring.back()), v = frame.V(ring.back());
    int64_t line = line_at(v);
    for (const Point p : ring) {
      const double next_u = frame.U(p), next_v = frame.V(p);
      const int64_t next_line = line_at(next_v);
      if (line != next_line) {
        const double slope = (next_u - u) / (next_v - v);
        edges.push_back(line < next_line ? FrameEdge{u, v, slope, line, next_line}
                                         : FrameEdge{next_u, next_v, slope, next_line, line});
      }
      u = next_u, v = next_v, line = next_line;
    }
  });
  return edges;
}

void Trim(double trim_nm, std::vector<ScanPiece>& pieces) {
  std::erase_if(pieces, [&](const ScanPiece& piece) { return piece.u1 - piece.u0 <= trim_nm; });
  for (ScanPiece& piece : pieces) {
    const double trim = std::min(trim_nm, (piece.u1 - piece.u0) / 4);
    piece.u0 += trim;
    piece.u1 -= trim;
  }
}

/// Returns the intersection of two lists of pieces. All lists are sorted by line, then along the
/// line.
std::vector<ScanPiece> InBoth(const std::vector<ScanPiece>& some,
                              const std::vector<ScanPiece>& others) {
  std::vector<ScanPiece> both;
  both.reserve(some.size());
  const auto ends_before = [](const ScanPiece& a, const ScanPiece& b) {
    return a.line != b.line ? a.line < b.line : a.u1 < b.u1;
  };
  for (size_t i = 0, k = 0; i < some.size() && k < others.size();) {
    const ScanPiece &a = some[i], &b = others[k];
    if (a.line == b.line && std::max(a.u0, b.u0) < std::min(a.u1, b.u1))
      both.push_back({a.line, std::max(a.u0, b.u0), std::min(a.u1, b.u1)});
    if (ends_before(a, b))
      ++i;
    else
      ++k;
  }
  return both;
}

/// Returns the parts of `pieces` that are in none of `others`. Both lists are sorted by line, then
/// along the line.
std::vector<ScanPiece> Without(const std::vector<ScanPiece>& others,
                               const std::vector<ScanPiece>& pieces) {
  std::vector<ScanPiece> left;
  left.reserve(pieces.size());
  size_t first = 0;
  for (ScanPiece piece : pieces) {
    const auto is_before = [&](const ScanPiece& other) {
      return other.line != piece.line ? other.line < piece.line : other.u1 <= piece.u0;
    };
    while (first < others.size() && is_before(others[first])) ++first;
    for (size_t i = first; i < others.size() && others[i].line == piece.line; ++i) {
      if (others[i].u0 >= piece.u1) break;
      if (others[i].u0 > piece.u0) left.push_back({piece.line, piece.u0, others[i].u0});
      piece.u0 = std::max(piece.u0, others[i].u1);
    }
    if (piece.u0 < piece.u1) left.push_back(piece);
  }
  return left;
}

}  // namespace

absl::StatusOr<std::vector<ScanPiece>> CutScanLines(const MultiPolygon& region,
                                                    const LineAxes& frame, const LineGrid& grid) {
  const std::vector<FrameEdge> edges = FrameEdges(region, frame, grid);
  if (edges.empty()) return std::vector<ScanPiece>{};
  int64_t first = INT64_MAX, last = INT64_MIN, crossings = 0;
  for (const FrameEdge& edge : edges) {
    first = std::min(first, edge.first);
    last = std::max(last, edge.last);
    crossings += edge.last - edge.first;
  }
  if (crossings / 2 > kMaxScanPieces || last - first > kMaxScanPieces || first < INT32_MIN ||
      last > INT32_MAX)
    return LimitError(Reason::kRequestTooLarge, "hatch lines of a layer", kMaxScanPieces,
                      std::max(crossings / 2, last - first));
  // The crossings of each line are counted first; then each crossing is written to its line's
  // range.
  std::vector<int32_t> begin(static_cast<size_t>(last - first) + 1);
  for (const FrameEdge& edge : edges)
    for (int64_t line = edge.first; line < edge.last; ++line)
      ++begin[static_cast<size_t>(line - first) + 1];
  for (size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
  std::vector<double> places(static_cast<size_t>(crossings));
  std::vector<int32_t> next(begin.begin(), begin.end() - 1);
  for (const FrameEdge& edge : edges) {
    for (int64_t line = edge.first; line < edge.last; ++line) {
      const double v = grid.V(static_cast<int32_t>(line));
      places[static_cast<size_t>(next[static_cast<size_t>(line - first)]++)] =
          edge.u + (v - edge.v) * edge.slope;
    }
  }
  std::vector<ScanPiece> pieces;
  pieces.reserve(static_cast<size_t>(crossings / 2));
  for (size_t i = 0; i + 1 < begin.size(); ++i) {
    const auto from = places.begin() + begin[i], to = places.begin() + begin[i + 1];
    std::sort(from, to);
    const auto line = static_cast<int32_t>(first + static_cast<int64_t>(i));
    for (auto place = from; place + 1 < to; place += 2)
      if (place[0] < place[1]) pieces.push_back({line, place[0], place[1]});
  }
  return pieces;
}

absl::StatusOr<std::vector<ScanPiece>> CutTrimmedLines(const HatchRegion& region,
                                                       const LineAxes& frame,
                                                       const LineGrid& grid) {
  auto pieces = CutScanLines(region.area, frame, grid);
  if (!pieces.ok()) return pieces;
  if (region.trim_nm > 0 && region.whole.empty()) Trim(region.trim_nm, *pieces);
  if (region.trim_nm > 0 && !region.whole.empty()) {
    auto whole = CutScanLines(region.whole, frame, grid);
    if (!whole.ok()) return whole;
    Trim(region.trim_nm, *whole);
    pieces = InBoth(*pieces, *whole);
  }
  if (region.narrow.empty()) return pieces;
  const auto narrow = CutScanLines(region.narrow, frame, grid);
  if (!narrow.ok()) return narrow;
  return Without(*narrow, *pieces);
}

}  // namespace slicefarm::exposure
