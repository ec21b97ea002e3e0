#include "services/ordering/algo/comb/island_travels.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "services/ordering/algo/comb/clear_ways.h"
#include "services/ordering/algo/comb/detour.h"
#include "services/ordering/algo/comb/edge_strips.h"

namespace slicefarm::ordering {
namespace {

/// The beads of top surfaces, in the order of printing.
EdgeStrips TopsOf(std::span<const Path> paths) {
  EdgeStrips edges;
  for (size_t i = 0; i < paths.size(); ++i)
    if (paths[i].feature == Feature::kTopSolidInfill)
      edges.AddLine(paths[i].points, static_cast<uint32_t>(i));
  edges.Build();
  return edges;
}

bool IsSeen(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kOverhangPerimeter ||
         feature == Feature::kTopSolidInfill;
}

/// How much longer than straight a way round may be where none is asked for. A retraction and its
/// end take as long as 15 mm of travel, and leave a mark.
constexpr double kWorthOfRetractionNm = 20.0 * kNmPerMm;

/// Longer hidden ways to a bead that is seen would make it begin with a gap.
constexpr double kLongestToSeenNm = 5.0 * kNmPerMm;

/// The seam of a wall and the starts of its loops lie no further from each other.
constexpr double kAtSeamNm = 1.5 * kNmPerMm;

/// How far the walls of a layer lie from those of the layer below, most often. A way to the layer
/// above that keeps so far off its own walls crosses none of that layer.
constexpr Coord kStepNm = 400'000;

class IslandTravels {
 public:
  /// All must outlive this.
  IslandTravels(const PolygonWithHoles& outline, const IslandEdges& edges,
                std::span<const Path> paths, const TravelOptions& options, CurledWays* curled)
      : outline_(outline),
        edges_(edges),
        paths_(paths),
        options_(options),
        curled_(curled),
        clearance_(OuterWallRadius(paths)),
        tops_(TopsOf(paths)) {}

  /// To paths[i] from the one before.
  Travel To(size_t i, WorkBudget& budget) {
    const Point from = EndOf(paths_[i - 1]), to = StartOf(paths_[i]);
    return from == to ? Travel{} : Between(from, to, i, LongestHidden(), budget);
  }

  /// To the first path from where the layer below has left the nozzle: over the place where this
  /// layer would have left it, so that the way does not depend on the layer below.
  Travel From(Point seam, WorkBudget& budget) {
    const Point to = StartOf(paths_.front());
    const std::optional<Point> inner = InnerStartAt(seam);
    const std::optional<Point> from = inner ? inner : BesideWall(seam);
    if (IsAt(seam, to) && !(from && edges_.Parts(*from, to))) return {true, {}};
    if (!from) return {};
    Travel travel = Between(*from, to, 0, LongestToSeam(), budget);
    travel.corners.insert(travel.corners.begin(), *from);
    return travel;
  }

  /// From the last path to where the layer above goes on.
  Leave To(Point seam, WorkBudget& budget) {
    const Point from = EndOf(paths_.back());
    const std::optional<Point> inner = InnerStartAt(seam);
    if (!inner && IsAt(seam, from)) return {from, {}};
    const std::optional<Point> to = inner ? inner : BesideWall(seam);
    if (!to) return {seam, {}};
    Leave leave{*to, {}};
    if (from == *to) return leave;
    leave.way = Between(from, *to, paths_.size(), LongestToSeam(), budget);
    if (!leave.way.corners.empty() || edges_.Grazes(from, *to, kStepNm)) leave.way.hidden = false;
    return leave;
  }

 private:
  /// After the first `printed` paths, to the next one if there is one. `longest_nm`: of a way that
  /// is hidden.
  Travel Between(Point from, Point to, size_t printed, double longest_nm, WorkBudget& budget) {
    Travel travel;
    if (clearance_ > 0 && IsToGoRound(from, to))
      travel.corners = Around(from, to, LongestFor(from, to), budget);
    if (curled_ != nullptr && curled_->Meets(from, travel.corners, to))
      if (auto corners = AroundCurled(from, to, budget)) travel.corners = *std::move(corners);
    const bool seen = printed < paths_.size() && IsSeen(paths_[printed].feature);
    if (seen) longest_nm = kLongestToSeenNm;
    travel.hidden = options_.hide && IsHidden(from, to, travel.corners, printed, longest_nm);
    return travel;
  }

  bool IsToGoRound(Point from, Point to) {
    return options_.avoid_crossing ? !Ways().IsClear(from, to)
                                   : edges_.Parts(from, to) || edges_.Grazes(from, to);
  }

  double LongestFor(Point from, Point to) const {
    if (options_.avoid_crossing) return LongestWay(from, to, options_);
    return options_.hide ? Distance(from, to) + kWorthOfRetractionNm : 0;
  }

  double LongestHidden() const {
    return options_.longest_hidden_mm > 0 ? options_.longest_hidden_mm * kNmPerMm
                                          : std::numeric_limits<double>::infinity();
  }

  /// A way over a change of layer has a part in either layer, which does not know the other one's,
  /// and a step from seam to seam between them: all together are no longer than a hidden way.
  double LongestToSeam() const { return LongestHidden() / 2 - kAtSeamNm; }

  ClearWays& Ways() {
    if (!ways_) ways_.emplace(MultiPolygon{outline_}, clearance_);
    return *ways_;
  }

  static bool IsAt(Point seam, Point start) { return Distance(start, seam) <= kAtSeamNm; }

  /// Where the first inner wall starts that starts at this seam: there layers meet. The other
  /// layer's starts nearly at the same place, and no outer wall is on the way, be it further in or
  /// out than this one's.
  std::optional<Point> InnerStartAt(Point seam) const {
    const auto first = std::ranges::find_if(paths_, [&](const Path& path) {
      return path.feature == Feature::kPerimeter && IsAt(seam, StartOf(path));
    });
    return first != paths_.end() ? std::optional(StartOf(*first)) : std::nullopt;
  }

  std::optional<Point> BesideWall(Point seam) {
    return clearance_ > 0 ? Ways().FromEdge(seam) : std::nullopt;
  }

  std::vector<Point> Around(Point from, Point to, double longest_nm, WorkBudget& budget) {
    return Ways().Find(from, to, longest_nm, budget).value_or(std::vector<Point>{});
  }

  std::optional<std::vector<Point>> AroundCurled(Point from, Point to, WorkBudget& budget) {
    if (!uncurled_) uncurled_.emplace(curled_->WaysThrough({outline_}));
    auto corners = curled_->Within(*uncurled_, from, to, LongestHidden(), budget);
    return corners ? corners : curled_->Around(from, to, budget);
  }

  /// Of a way after the first `printed` paths.
  bool IsHidden(Point from, Point to, const std::vector<Point>& corners, size_t printed,
                double longest_nm) const {
    double length = 0;
    std::vector<Point> places = corners;
    places.push_back(to);
    for (const Point place : places) {
      if (edges_.Parts(from, place) || edges_.Grazes(from, place)) return false;
      if (tops_.Crosses(from, place, static_cast<uint32_t>(printed))) return false;
      length += Distance(from, place);
      from = place;
    }
    if (length > longest_nm) return false;
    // It meets no edge: if one of its places is inside, all of it is.
    return edges_.Surrounds(to);
  }

  const PolygonWithHoles& outline_;
  const IslandEdges& edges_;
  std::span<const Path> paths_;
  const TravelOptions& options_;
  CurledWays* const curled_;  ///< null: nothing has curled up
  const Coord clearance_;
  EdgeStrips tops_;
  std::optional<ClearWays> ways_;  ///< once asked for
  std::optional<ClearWays> uncurled_;  ///< the same, off what has curled up
};

}  // namespace

IslandWays WaysInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                        std::span<const Path> paths, const Meetings& meetings,
                        const TravelOptions& options, WorkBudget& budget, CurledWays* curled) {
  IslandWays ways{std::vector<Travel>(paths.size()), {}};
  if (meetings.above) ways.leave = Leave{*meetings.above, {}};
  if (edges.empty() || paths.empty()) return ways;
  if (!options.hide && !options.avoid_crossing && curled == nullptr) return ways;
  IslandTravels island(outline, edges, paths, options, curled);
  if (meetings.below) ways.travels[0] = island.From(*meetings.below, budget);
  for (size_t i = 1; i < paths.size(); ++i) ways.travels[i] = island.To(i, budget);
  if (meetings.above) ways.leave = island.To(*meetings.above, budget);
  return ways;
}

}  // namespace slicefarm::ordering
