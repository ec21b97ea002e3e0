#include "services/ordering/algo/comb/island_travels.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "services/ordering/algo/comb/detour.h"
#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/comb/travel_paths.h"

namespace slicefarm::ordering {
namespace {

/// Returns the beads of top surfaces. Their rank (EdgeStrips) is the index of the path.
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

/// Largest extra length in nm of a detour when the options request no detours. A retraction and the
/// restart after it take as much time as 15 mm of travel, and leave a mark.
constexpr double kWorthOfRetractionNm = 20.0 * kNmPerMm;

/// Longest hidden travel to a visible bead, in nm. After a longer travel the bead would begin with
/// a gap.
constexpr double kLongestToSeenNm = 5.0 * kNmPerMm;

/// Largest distance in nm between the seam of a wall and the starts of the wall's loops.
constexpr double kAtSeamNm = 1.5 * kNmPerMm;

/// Longest travel to the layer above that needs no retraction, in nm. A longer travel may cross a
/// wall of that layer, which is unknown here.
constexpr double kSurelyWithinNm = 0.8 * kNmPerMm;

class IslandTravels {
 public:
  /// Keeps references to all arguments, which must outlive this object.
  IslandTravels(const PolygonWithHoles& outline, const IslandEdges& edges,
                std::span<const Path> paths, const TravelOptions& options, CurlAvoidance* curled)
      : outline_(outline),
        edges_(edges),
        paths_(paths),
        options_(options),
        curled_(curled),
        clearance_(OuterWallRadius(paths)),
        tops_(TopsOf(paths)) {}

  /// Returns the travel to paths[i] from the previous path.
  Travel To(size_t i, WorkBudget& budget) {
    const Point from = EndOf(paths_[i - 1]), to = StartOf(paths_[i]);
    return from == to ? Travel{} : Between(from, to, i, budget);
  }

  /// Returns the travel to the first path from the end of the layer below. The travel passes the
  /// point where this layer itself would have changed the layer, so the travel after this point
  /// does not depend on the layer below. The walls of the layer below are unknown; therefore the
  /// travel is hidden only at the seam.
  Travel From(Point seam, WorkBudget& budget) {
    const Point to = StartOf(paths_.front());
    const std::optional<Point> inner = InnerStartAt(seam);
    const std::optional<Point> from = inner ? inner : BesideWall(seam);
    if (IsAt(seam, to) && !(from && edges_.Parts(*from, to))) return {true, {}};
    if (!from) return {};
    std::vector<Point> corners = PathBetween(*from, to, budget);
    corners.insert(corners.begin(), *from);
    return {false, std::move(corners)};
  }

  /// Returns the travel from the last path to the point where the layer above continues.
  ExitTravel To(Point seam, WorkBudget& budget) {
    const Point from = EndOf(paths_.back());
    const std::optional<Point> inner = InnerStartAt(seam);
    if (!inner && IsAt(seam, from)) return {from, {}};
    const std::optional<Point> to = inner ? inner : BesideWall(seam);
    if (!to) return {seam, {}};
    ExitTravel exit_travel{*to, {}};
    if (from == *to) return exit_travel;
    exit_travel.travel.corners = PathBetween(from, *to, budget);
    exit_travel.travel.over_wall = Distance(from, *to) > kSurelyWithinNm;
    return exit_travel;
  }

 private:
  /// Returns the travel to the next path after the first `printed` paths.
  Travel Between(Point from, Point to, size_t printed, WorkBudget& budget) {
    Travel travel{false, PathBetween(from, to, budget)};
    const std::vector<Point> points = PointsOf(from, travel.corners, to);
    const double longest_nm = IsSeen(paths_[printed].feature) ? kLongestToSeenNm : LongestHidden();
    travel.hidden = options_.hide && IsHidden(points, printed, longest_nm);
    travel.over_wall = !travel.hidden && edges_.Grazes(points, 0);
    return travel;
  }

  std::vector<Point> PathBetween(Point from, Point to, WorkBudget& budget) {
    std::vector<Point> corners;
    if (clearance_ > 0 && IsToGoRound(from, to))
      corners = Around(from, to, LongestFor(from, to), budget);
    if (curled_ != nullptr && curled_->Meets(from, corners, to))
      if (auto others = AroundCurled(from, to, budget)) corners = *std::move(others);
    return corners;
  }

  bool IsToGoRound(Point from, Point to) {
    return options_.avoid_crossing ? !Routes().IsClear(from, to)
                                   : edges_.Parts(from, to) || edges_.Grazes(from, to);
  }

  double LongestFor(Point from, Point to) const {
    if (options_.avoid_crossing) return LongestDetour(from, to, options_);
    return options_.hide ? Distance(from, to) + kWorthOfRetractionNm : 0;
  }

  double LongestHidden() const {
    return options_.longest_hidden_mm > 0 ? options_.longest_hidden_mm * kNmPerMm
                                          : std::numeric_limits<double>::infinity();
  }

  TravelPaths& Routes() {
    if (!routes_) routes_.emplace(MultiPolygon{outline_}, clearance_);
    return *routes_;
  }

  static bool IsAt(Point seam, Point start) { return Distance(start, seam) <= kAtSeamNm; }

  /// Returns the start of the first inner wall that starts at this seam, where the nozzle changes
  /// the layer. The other layer's inner wall starts nearly at the same point. Therefore no outer
  /// wall is between the two, whether the other layer's outer wall is further inside or outside.
  std::optional<Point> InnerStartAt(Point seam) const {
    const auto first = std::ranges::find_if(paths_, [&](const Path& path) {
      return path.feature == Feature::kPerimeter && IsAt(seam, StartOf(path));
    });
    return first != paths_.end() ? std::optional(StartOf(*first)) : std::nullopt;
  }

  std::optional<Point> BesideWall(Point seam) {
    return clearance_ > 0 ? Routes().FromEdge(seam) : std::nullopt;
  }

  std::vector<Point> Around(Point from, Point to, double longest_nm, WorkBudget& budget) {
    return Routes().Find(from, to, longest_nm, budget).value_or(std::vector<Point>{});
  }

  std::optional<std::vector<Point>> AroundCurled(Point from, Point to, WorkBudget& budget) {
    if (!uncurled_) uncurled_.emplace(curled_->PathsThrough({outline_}));
    auto corners = curled_->Within(*uncurled_, from, to, LongestHidden(), budget);
    return corners ? corners : curled_->Around(from, to, budget);
  }

  /// Returns true if a travel after the first `printed` paths is hidden.
  bool IsHidden(std::span<const Point> points, size_t printed, double longest_nm) const {
    double length = 0;
    for (size_t i = 1; i < points.size(); ++i) {
      if (edges_.Parts(points[i - 1], points[i])) return false;
      if (tops_.Crosses(points[i - 1], points[i], static_cast<uint32_t>(printed))) return false;
      length += Distance(points[i - 1], points[i]);
    }
    if (length > longest_nm || edges_.Grazes(points)) return false;
    // The travel crosses no edge: if one of its points is inside, all points are.
    return edges_.Surrounds(points.back());
  }

  const PolygonWithHoles& outline_;
  const IslandEdges& edges_;
  std::span<const Path> paths_;
  const TravelOptions& options_;
  CurlAvoidance* const curled_;  ///< null if there is no curled area
  const Coord clearance_;
  EdgeStrips tops_;
  std::optional<TravelPaths> routes_;    ///< built on first use
  std::optional<TravelPaths> uncurled_;  ///< like `routes_`, but around curled areas
};

}  // namespace

IslandPaths PathsInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                          std::span<const Path> paths, const Meetings& meetings,
                          const TravelOptions& options, WorkBudget& budget, CurlAvoidance* curled) {
  IslandPaths routes{std::vector<Travel>(paths.size()), {}};
  if (meetings.above) routes.exit_travel = ExitTravel{*meetings.above, {}};
  if (edges.empty() || paths.empty()) return routes;
  if (!options.hide && !options.avoid_crossing && curled == nullptr) return routes;
  IslandTravels island(outline, edges, paths, options, curled);
  if (meetings.below) routes.travels[0] = island.From(*meetings.below, budget);
  for (size_t i = 1; i < paths.size(); ++i) routes.travels[i] = island.To(i, budget);
  if (meetings.above) routes.exit_travel = island.To(*meetings.above, budget);
  return routes;
}

}  // namespace slicefarm::ordering
