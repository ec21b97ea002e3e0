#include "services/infill/algo/lines/scan_lines.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Lines [first, last) that an edge between two heights meets. Edges count as half-open intervals:
/// first <= v < last.
struct LineSpan {
  int64_t first = 0;
  int64_t last = 0;
};

LineSpan LinesBetween(double v0, double v1, const LineFamily& family) {
  const auto [low, high] = std::minmax(v0, v1);
  const auto index = [&](double v) {
    return static_cast<int64_t>(std::ceil((v - family.phase_nm) / family.pitch_nm));
  };
  return {index(low), index(high)};
}

/// Calls visit(v of point i, v of point i + 1, i) for the edges of a ring.
template <typename Visit>
void ForEachEdge(const Polygon& ring, const LineAxes& frame, Visit visit) {
  if (ring.empty()) return;
  const double start = frame.V(ring[0]);
  double v = start;
  for (size_t i = 0; i < ring.size(); ++i) {
    const double next = i + 1 == ring.size() ? start : frame.V(ring[i + 1]);
    visit(v, next, i);
    v = next;
  }
}

/// Appends the crossings of one ring in their order along the ring, and links them to a cycle.
void AppendCrossings(int32_t ring_index, const LineFamily& family, int64_t first_line,
                     ScanLines& lines) {
  const Polygon& ring = *lines.rings[ring_index];
  const auto begin = static_cast<int32_t>(lines.crossings.size());
  ForEachEdge(ring, lines.frame, [&](double v0, double v1, size_t i) {
    const LineSpan span = LinesBetween(v0, v1, family);
    if (span.first == span.last) return;
    const double u0 = lines.frame.U(ring[i]);
    const double u1 = lines.frame.U(ring[i + 1 == ring.size() ? 0 : i + 1]);
    const double slope = (u1 - u0) / (v1 - v0);
    for (int64_t k = 0; k < span.last - span.first; ++k) {
      const int64_t line = v1 > v0 ? span.first + k : span.last - 1 - k;
      const double v = family.phase_nm + static_cast<double>(line) * family.pitch_nm;
      const double u = std::clamp(u0 + (v - v0) * slope, std::min(u0, u1), std::max(u0, u1));
      const auto at = static_cast<int32_t>(lines.crossings.size());
      lines.crossings.push_back({u, static_cast<int32_t>(line - first_line), ring_index,
                                 static_cast<int32_t>(i), at - 1, at + 1, 0});
    }
  });
  const auto end = static_cast<int32_t>(lines.crossings.size());
  if (begin == end) return;
  lines.crossings[begin].previous = end - 1;
  lines.crossings[end - 1].next = begin;
}

/// Sorts crossings by line (counting sort), then by u within each line. Equal crossings keep their
/// order of creation.
void SortByLine(int32_t line_count, ScanLines& lines) {
  lines.line_begin.assign(line_count + 1, 0);
  for (const Crossing& crossing : lines.crossings) ++lines.line_begin[crossing.line + 1];
  std::partial_sum(lines.line_begin.begin(), lines.line_begin.end(), lines.line_begin.begin());
  lines.order.resize(lines.crossings.size());
  std::vector<int32_t> at(lines.line_begin.begin(), lines.line_begin.end() - 1);
  for (size_t i = 0; i < lines.crossings.size(); ++i)
    lines.order[at[lines.crossings[i].line]++] = static_cast<int32_t>(i);
  for (int32_t line = 0; line < line_count; ++line) {
    std::sort(lines.order.begin() + lines.line_begin[line],
              lines.order.begin() + lines.line_begin[line + 1], [&](int32_t a, int32_t b) {
                const double ua = lines.crossings[a].u, ub = lines.crossings[b].u;
                return ua != ub ? ua < ub : a < b;
              });
  }
  for (size_t place = 0; place < lines.order.size(); ++place)
    lines.crossings[lines.order[place]].place = static_cast<int32_t>(place);
}

}  // namespace

Point ScanLines::PointOf(const Crossing& crossing) const {
  return frame.At(crossing.u, VOf(crossing.line));
}

double ScanLines::PieceLength(int32_t piece) const {
  return crossings[order[2 * piece + 1]].u - crossings[order[2 * piece]].u;
}

double ScanLines::TotalLength() const {
  double length = 0;
  for (int32_t piece = 0; piece < PieceCount(); ++piece) length += PieceLength(piece);
  return length;
}

absl::StatusOr<ScanLines> CutLines(const MultiPolygon& region, const LineFamily& family) {
  ScanLines lines;
  lines.frame = LineAxes(family.angle_rad);
  lines.pitch = family.pitch_nm;
  ForEachRing(region, [&](const Polygon& ring) { lines.rings.push_back(&ring); });
  int64_t first = std::numeric_limits<int64_t>::max(), last = std::numeric_limits<int64_t>::min();
  int64_t count = 0;
  for (const Polygon* ring : lines.rings) {
    ForEachEdge(*ring, lines.frame, [&](double v0, double v1, size_t) {
      const LineSpan span = LinesBetween(v0, v1, family);
      if (span.first == span.last) return;
      first = std::min(first, span.first);
      last = std::max(last, span.last);
      count += span.last - span.first;
    });
  }
  if (absl::Status ok = CheckLineCount(static_cast<double>(count / 2)); !ok.ok()) return ok;
  lines.line_begin = {0};
  if (count == 0) return lines;
  lines.first_v = family.phase_nm + static_cast<double>(first) * family.pitch_nm;
  lines.crossings.reserve(count);
  for (size_t ring = 0; ring < lines.rings.size(); ++ring)
    AppendCrossings(static_cast<int32_t>(ring), family, first, lines);
  SortByLine(static_cast<int32_t>(last - first), lines);
  return lines;
}

}  // namespace slicefarm::infill
