#include "services/infill/algo/lines/line_ends.h"

#include <algorithm>
#include <numeric>

#include "services/infill/algo/lines/line_limit.h"

namespace slicefarm::infill {
namespace {

/// Point of a ring in the frame of a line family.
struct FramePoint {
  double u = 0, v = 0;
  int64_t line = 0;  ///< first line that is not below the point
};

/// Returns the least integer that is not less than t, like std::ceil, without a function call.
int64_t Ceiling(double t) {
  const auto whole = static_cast<int64_t>(t);
  return whole + (static_cast<double>(whole) < t ? 1 : 0);
}

}  // namespace

absl::StatusOr<LineEnds> LineEnds::Of(const MultiPolygon& region, const LineFamily& family) {
  const LineAxes frame(family.angle_rad);
  const auto in_frame = [&](Point p) {
    const double v = frame.V(p);
    return FramePoint{frame.U(p), v, Ceiling((v - family.phase_nm) / family.pitch_nm)};
  };
  std::vector<End> ends;
  double count = 0;
  const auto add = [&](const FramePoint& a, const FramePoint& b) {
    if (a.line == b.line) return;
    const auto [from, to] = std::minmax(a.line, b.line);
    count += static_cast<double>(to - from);
    if (!CheckLineCount(count / 2).ok()) return;
    const double slope = (b.u - a.u) / (b.v - a.v);
    for (int64_t line = from; line < to; ++line) {
      const double v = family.phase_nm + static_cast<double>(line) * family.pitch_nm;
      ends.push_back(
          {line, std::clamp(a.u + (v - a.v) * slope, std::min(a.u, b.u), std::max(a.u, b.u))});
    }
  };
  ForEachRing(region, [&](const Polygon& ring) {
    if (ring.empty()) return;
    const FramePoint start = in_frame(ring[0]);
    FramePoint before = start;
    for (size_t i = 1; i < ring.size(); ++i) {
      const FramePoint at = in_frame(ring[i]);
      add(before, at);
      before = at;
    }
    add(before, start);
  });
  if (absl::Status ok = CheckLineCount(count / 2); !ok.ok()) return ok;
  LineEnds result;
  result.Sort(ends);
  return result;
}

/// Sorts the ends by line (counting sort), then by u.
void LineEnds::Sort(const std::vector<End>& ends) {
  if (ends.empty()) return;
  const auto [least, most] = std::ranges::minmax(ends, {}, &End::line);
  first_ = least.line;
  begin_.assign(static_cast<size_t>(most.line - first_) + 2, 0);
  for (const End& end : ends) ++begin_[static_cast<size_t>(end.line - first_) + 1];
  std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
  ends_.resize(ends.size());
  std::vector<int32_t> at(begin_.begin(), begin_.end() - 1);
  for (const End& end : ends)
    ends_[static_cast<size_t>(at[static_cast<size_t>(end.line - first_)]++)] = end.u;
  for (size_t line = 0; line + 1 < begin_.size(); ++line)
    std::sort(ends_.begin() + begin_[line], ends_.begin() + begin_[line + 1]);
}

std::span<const double> LineEnds::On(int64_t line) const {
  if (line < first() || line >= last()) return {};
  const auto at = begin_.begin() + (line - first_);
  return std::span(ends_).subspan(static_cast<size_t>(at[0]), static_cast<size_t>(at[1] - at[0]));
}

}  // namespace slicefarm::infill
