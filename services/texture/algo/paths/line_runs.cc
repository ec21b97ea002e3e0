#include "services/texture/algo/paths/line_runs.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace slicefarm::texture {
namespace {

/// A place along a line: in a step from edge to edge, and how far.
struct LinePlace {
  size_t step = 0;
  double share = 0;

  friend auto operator<=>(const LinePlace&, const LinePlace&) = default;
};

struct LinePart {
  LinePlace from;
  LinePlace to;
};

/// A line with its places in the map.
class MappedLine {
 public:
  MappedLine(const SurfaceMap& map, const LevelLine& line) : map_(map), line_(line) {
    for (const EdgePlace& place : line.places) {
      const Eigen::Vector2d &low = map.map_mm()[place.low], &high = map.map_mm()[place.high];
      places_.push_back(low + place.share * (high - low));
    }
  }

  size_t steps() const { return line_.triangles.size(); }

  Eigen::Vector2d At(const LinePlace& place) const {
    return places_[place.step] + place.share * (places_[place.step + 1] - places_[place.step]);
  }

  /// All places where something may change, in order, the two ends among them.
  std::vector<LinePlace> Cuts(const WorkArea& area) const {
    std::vector<LinePlace> cuts = {{0, 0}};
    std::vector<double> shares;
    for (size_t step = 0; step < steps(); ++step) {
      shares.clear();
      area.Cuts(places_[step], places_[step + 1], &shares);
      std::sort(shares.begin(), shares.end());
      for (const double share : shares) cuts.push_back({step, std::clamp(share, 0.0, 1.0)});
    }
    cuts.push_back({steps() - 1, 1});
    return cuts;
  }

  /// Between two places: in the middle of the middle step.
  Eigen::Vector2d Middle(const LinePlace& from, const LinePlace& to) const {
    if (from.step == to.step) return At({from.step, (from.share + to.share) / 2});
    if (to.step > from.step + 1) return At({(from.step + to.step) / 2, 0.5});
    return 1 - from.share > to.share ? At({from.step, (from.share + 1) / 2})
                                     : At({to.step, to.share / 2});
  }

  double Length(const LinePart& part) const {
    if (part.from.step == part.to.step) return (At(part.to) - At(part.from)).norm();
    double length = (At({part.from.step, 1}) - At(part.from)).norm();
    for (size_t step = part.from.step + 1; step < part.to.step; ++step)
      length += (places_[step + 1] - places_[step]).norm();
    return length + (At(part.to) - At({part.to.step, 0})).norm();
  }

  Run RunOf(const LinePart& part) const {
    Run run = {PointAt(part.from)};
    for (size_t step = part.from.step + 1; step <= part.to.step; ++step)
      run.push_back(PointOf(map_, line_.places[step], line_.triangles[step]));
    if (part.to.share > 0) run.push_back(PointAt(part.to));
    return run;
  }

 private:
  SurfacePoint PointAt(const LinePlace& place) const {
    const int32_t triangle = line_.triangles[place.step];
    const SurfacePoint from = PointOf(map_, line_.places[place.step], triangle);
    if (place.share == 0) return from;
    SurfacePoint to = PointOf(map_, line_.places[place.step + 1], triangle);
    if (place.share < 1) to.weights = (1 - place.share) * from.weights + place.share * to.weights;
    return to;
  }

  const SurfaceMap& map_;
  const LevelLine& line_;
  std::vector<Eigen::Vector2d> places_;
};

}  // namespace

std::vector<Run> RunsOf(const SurfaceMap& map, const LevelLine& line, const WorkArea& area,
                        double least_mm) {
  const MappedLine mapped(map, line);
  const std::vector<LinePlace> cuts = mapped.Cuts(area);
  std::vector<LinePart> parts;
  for (size_t i = 0; i + 1 < cuts.size(); ++i) {
    if (!(cuts[i] < cuts[i + 1]) || !area.Contains(mapped.Middle(cuts[i], cuts[i + 1]))) continue;
    if (!parts.empty() && parts.back().to == cuts[i])
      parts.back().to = cuts[i + 1];
    else
      parts.push_back({cuts[i], cuts[i + 1]});
  }
  std::vector<Run> runs;
  for (const LinePart& part : parts)
    if (mapped.Length(part) > least_mm) runs.push_back(mapped.RunOf(part));
  return runs;
}

}  // namespace slicefarm::texture
