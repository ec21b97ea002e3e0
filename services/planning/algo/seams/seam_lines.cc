#include "services/planning/algo/seams/seam_lines.h"

#include <algorithm>

#include "common/geometry/measure.h"

namespace slicefarm::planning {
namespace {

constexpr size_t kReach = 8;  // number of layers

/// Returns the lines as indices of choices, each line bottom up.
std::vector<std::vector<size_t>> LinesOf(std::span<const SeamChoice> choices) {
  constexpr size_t kNone = SIZE_MAX;
  std::vector<std::vector<size_t>> lines;
  std::vector<size_t> line_of(choices.size(), kNone);
  std::vector<bool> goes_on(choices.size(), false);
  for (size_t i = 0; i < choices.size(); ++i) {
    const auto parent = static_cast<size_t>(choices[i].parent);
    if (choices[i].parent < 0 || goes_on[parent]) {
      line_of[i] = lines.size();
      lines.emplace_back();
    } else {
      line_of[i] = line_of[parent];
      goes_on[parent] = true;
    }
    lines[line_of[i]].push_back(i);
  }
  return lines;
}

/// Returns the reach of the mean around each choice of a line. The mean does not extend beyond the
/// line's ends or beyond a fixed choice.
std::vector<size_t> ReachesOn(const std::vector<size_t>& line,
                              std::span<const SeamChoice> choices) {
  std::vector<size_t> reaches(line.size(), kReach);
  const auto limit = [&](size_t i, size_t& left) {
    left = choices[line[i]].IsFixed() ? 0 : left;
    reaches[i] = std::min(reaches[i], left++);
  };
  for (size_t i = 0, left = 0; i < line.size(); ++i) limit(i, left);
  for (size_t i = line.size(), left = 0; i-- > 0;) limit(i, left);
  return reaches;
}

/// Returns the weighted mean of the seams up to `reach` below and above. Nearer seams have more
/// weight.
Point MeanAround(size_t middle, size_t reach, const std::vector<size_t>& line,
                 std::span<const SeamChoice> choices) {
  Coord x = 0, y = 0;
  for (size_t i = middle - reach; i <= middle + reach; ++i) {
    const size_t apart = i < middle ? middle - i : i - middle;
    const auto weight = static_cast<Coord>(reach + 1 - apart);
    x += weight * choices[line[i]].at.x;
    y += weight * choices[line[i]].at.y;
  }
  const auto all = static_cast<Coord>((reach + 1) * (reach + 1));
  return {x / all, y / all};
}

Point NearestOn(const SeamChoice& choice, Point to) {
  const Point before = NearestOnSegment(to, choice.before, choice.at);
  const Point after = NearestOnSegment(to, choice.at, choice.after);
  return SquaredNorm(before - to) < SquaredNorm(after - to) ? before : after;
}

}  // namespace

std::vector<Point> SmoothSeams(std::span<const SeamChoice> choices) {
  std::vector<Point> seams(choices.size());
  for (const std::vector<size_t>& line : LinesOf(choices)) {
    const std::vector<size_t> reaches = ReachesOn(line, choices);
    for (size_t i = 0; i < line.size(); ++i)
      seams[line[i]] = NearestOn(choices[line[i]], MeanAround(i, reaches[i], line, choices));
  }
  return seams;
}

}  // namespace slicefarm::planning
