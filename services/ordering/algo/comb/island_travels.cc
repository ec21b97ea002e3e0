#include "services/ordering/algo/comb/island_travels.h"

#include <algorithm>
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

class IslandTravels {
 public:
  /// All must outlive this.
  IslandTravels(const PolygonWithHoles& outline, const IslandEdges& edges,
                std::span<const Path> paths, const TravelOptions& options)
      : outline_(outline),
        edges_(edges),
        paths_(paths),
        options_(options),
        clearance_(OuterWallRadius(paths)),
        tops_(TopsOf(paths)) {}

  /// To paths[i] from the one before.
  Travel To(size_t i, WorkBudget& budget) {
    const Point from = EndOf(paths_[i - 1]), to = StartOf(paths_[i]);
    if (from == to) return {};
    if (options_.avoid_crossing) {
      std::vector<Point> corners;
      if (clearance_ > 0 && !Ways().IsClear(from, to))
        corners = Around(from, to, LongestWay(from, to, options_), budget);
      const bool hidden = CanHide(i) && IsHidden(from, to, corners, i);
      return {hidden, std::move(corners)};
    }
    if (!CanHide(i)) return {};
    if (!edges_.Parts(from, to)) return {IsHidden(from, to, {}, i), {}};
    if (clearance_ == 0) return {};
    std::vector<Point> corners = Around(from, to, LongestHiddenWay(from, to), budget);
    if (corners.empty() || !IsHidden(from, to, corners, i)) return {};
    return {true, std::move(corners)};
  }

 private:
  bool CanHide(size_t i) const { return options_.hide && !IsSeen(paths_[i].feature); }

  /// Where no way round is asked for: one that takes less time than the retraction that it saves.
  static double LongestHiddenWay(Point from, Point to) {
    return Distance(from, to) + static_cast<double>(kCrossingNm);
  }

  ClearWays& Ways() {
    if (!ways_) ways_.emplace(MultiPolygon{outline_}, clearance_);
    return *ways_;
  }

  std::vector<Point> Around(Point from, Point to, double longest_nm, WorkBudget& budget) {
    return Ways().Find(from, to, longest_nm, budget).value_or(std::vector<Point>{});
  }

  bool IsHidden(Point from, Point to, const std::vector<Point>& corners, size_t i) const {
    double length = 0;
    std::vector<Point> places = corners;
    places.push_back(to);
    for (const Point place : places) {
      if (edges_.Parts(from, place)) return false;
      if (tops_.Crosses(from, place, static_cast<uint32_t>(i))) return false;
      length += Distance(from, place);
      from = place;
    }
    const double longest = options_.longest_hidden_mm * kNmPerMm;
    if (longest > 0 && length > longest) return false;
    // It meets no edge: if one of its places is inside, all of it is.
    return edges_.Surrounds(to);
  }

  const PolygonWithHoles& outline_;
  const IslandEdges& edges_;
  std::span<const Path> paths_;
  const TravelOptions& options_;
  const Coord clearance_;
  EdgeStrips tops_;
  std::optional<ClearWays> ways_;  ///< once asked for
};

}  // namespace

std::vector<Travel> TravelsInIsland(const PolygonWithHoles& outline, const IslandEdges& edges,
                                    std::span<const Path> paths, const TravelOptions& options,
                                    WorkBudget& budget) {
  std::vector<Travel> travels(paths.size());
  if (edges.empty() || paths.size() < 2) return travels;
  if (!options.hide && !options.avoid_crossing) return travels;
  IslandTravels island(outline, edges, paths, options);
  for (size_t i = 1; i < paths.size(); ++i) travels[i] = island.To(i, budget);
  return travels;
}

}  // namespace slicefarm::ordering
