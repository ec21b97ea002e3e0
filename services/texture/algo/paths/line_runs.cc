#include "services/texture/algo/paths/line_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::texture {
namespace {

/// Position on a line: the index of a step from edge to edge, and the share of this step.
struct LinePosition {
  size_t step = 0;
  double share = 0;
};

struct LinePart {
  LinePosition from;
  LinePosition to;
};

/// Line with its positions in the map.
class MappedLine {
 public:
  MappedLine(const SurfaceMap& map, const LevelLine& line) : map_(map), line_(line) {
    for (const EdgePoint& point : line.points) {
      const Eigen::Vector2d &low = map.map_mm()[point.low], &high = map.map_mm()[point.high];
      map_points_.push_back(low + point.share * (high - low));
    }
  }

  size_t steps() const { return line_.triangles.size(); }

  Eigen::Vector2d At(const LinePosition& place) const {
    return map_points_[place.step] +
           place.share * (map_points_[place.step + 1] - map_points_[place.step]);
  }

  /// Returns the parts of the line in the area. Each piece of a step between two cuts is tested
  /// separately. Reason: if an outline passes through the point between two steps, rounding may
  /// assign the crossing to neither step.
  std::vector<LinePart> PartsIn(const WorkArea& area) const {
    std::vector<LinePart> parts;
    std::vector<double> shares;
    bool inside = false;
    for (size_t step = 0; step < steps(); ++step) {
      shares.assign(1, 1.0);
      area.Cuts(map_points_[step], map_points_[step + 1], &shares);
      std::sort(shares.begin(), shares.end());
      double from = 0;
      for (double to : shares) {
        to = std::clamp(to, 0.0, 1.0);
        if (!(to > from)) continue;
        const bool was_inside = inside;
        inside = area.Contains(At({step, (from + to) / 2}));
        if (inside && was_inside) parts.back().to = {step, to};
        if (inside && !was_inside) parts.push_back({{step, from}, {step, to}});
        from = to;
      }
    }
    return parts;
  }

  double Length(const LinePart& part) const {
    if (part.from.step == part.to.step) return (At(part.to) - At(part.from)).norm();
    double length = (At({part.from.step, 1}) - At(part.from)).norm();
    for (size_t step = part.from.step + 1; step < part.to.step; ++step)
      length += (map_points_[step + 1] - map_points_[step]).norm();
    return length + (At(part.to) - At({part.to.step, 0})).norm();
  }

  Run RunOf(const LinePart& part) const {
    Run run = {PointAt(part.from)};
    for (size_t step = part.from.step + 1; step <= part.to.step; ++step)
      run.push_back(PointOf(map_, line_.points[step], line_.triangles[step]));
    if (part.to.share > 0) run.push_back(PointAt(part.to));
    return run;
  }

 private:
  SurfacePoint PointAt(const LinePosition& place) const {
    const int32_t triangle = line_.triangles[place.step];
    const SurfacePoint from = PointOf(map_, line_.points[place.step], triangle);
    if (place.share == 0) return from;
    SurfacePoint to = PointOf(map_, line_.points[place.step + 1], triangle);
    if (place.share < 1) to.weights = (1 - place.share) * from.weights + place.share * to.weights;
    return to;
  }

  const SurfaceMap& map_;
  const LevelLine& line_;
  std::vector<Eigen::Vector2d> map_points_;
};

}  // namespace

std::vector<Run> RunsOf(const SurfaceMap& map, const LevelLine& line, const WorkArea& area,
                        double least_mm) {
  const MappedLine mapped(map, line);
  const std::vector<LinePart> parts = mapped.PartsIn(area);
  std::vector<Run> runs;
  for (const LinePart& part : parts)
    if (mapped.Length(part) > least_mm) runs.push_back(mapped.RunOf(part));
  return runs;
}

}  // namespace slicefarm::texture
