#include "services/ordering/algo/comb/island_travels.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "services/ordering/algo/comb/edge_strips.h"
#include "services/ordering/algo/comb/inside_ways.h"

namespace slicefarm::ordering {
namespace {

EdgeStrips EdgesOf(const PolygonWithHoles& outline) {
  EdgeStrips edges;
  edges.AddRing(outline.outer);
  for (const Polygon& hole : outline.holes) edges.AddRing(hole);
  edges.Build();
  return edges;
}

/// The beads of top surfaces, in the order of printing.
EdgeStrips TopsOf(std::span<const Path> paths) {
  EdgeStrips edges;
  for (size_t i = 0; i < paths.size(); ++i)
    if (paths[i].feature == Feature::kTopSolidInfill)
      edges.AddLine(paths[i].points, static_cast<uint32_t>(i));
  edges.Build();
  return edges;
}

bool IsOuterWall(const Path& path) {
  return path.inset == 0 && (path.feature == Feature::kExternalPerimeter ||
                             path.feature == Feature::kOverhangPerimeter);
}

/// The middles of the outer walls.
EdgeStrips WallsOf(std::span<const Path> paths) {
  EdgeStrips edges;
  for (const Path& path : paths) {
    if (!IsOuterWall(path)) continue;
    path.closed ? edges.AddRing(path.points) : edges.AddLine(path.points);
  }
  edges.Build();
  return edges;
}

/// Half the outer walls' mean width: where their middle lies.
Coord ClearanceOf(std::span<const Path> paths) {
  Coord sum = 0, count = 0;
  for (const Path& path : paths) {
    if (!IsOuterWall(path) || !path.closed) continue;
    sum = std::accumulate(path.widths_nm.begin(), path.widths_nm.end(), sum);
    count += std::ssize(path.widths_nm);
  }
  return count == 0 ? 0 : sum / (2 * count);
}

bool IsSeen(Feature feature) {
  return feature == Feature::kExternalPerimeter || feature == Feature::kOverhangPerimeter ||
         feature == Feature::kTopSolidInfill;
}

class IslandTravels {
 public:
  /// All must outlive this.
  IslandTravels(const PolygonWithHoles& outline, std::span<const Path> paths,
                const TravelOptions& options)
      : outline_(outline), paths_(paths), options_(options), edge_(EdgesOf(outline)),
        walls_(WallsOf(paths)), tops_(TopsOf(paths)) {
    const Coord clearance = options.avoid_crossing ? ClearanceOf(paths) : 0;
    if (clearance > 0) ways_.emplace(outline, clearance);
  }

  /// To paths[i] from the one before.
  Travel To(size_t i, WorkBudget& budget) {
    const Point from = EndOf(paths_[i - 1]), to = StartOf(paths_[i]);
    Travel travel;
    if (from == to) return travel;
    if (ways_ && !ways_->IsClear(from, to)) travel.corners = Around(from, to, budget);
    travel.hidden = options_.hide && !IsSeen(paths_[i].feature) && IsHidden(from, to, travel, i);
    return travel;
  }

 private:
  double Longest(double straight_nm) const {
    double longest = std::numeric_limits<double>::infinity();
    if (options_.max_detour_mm > 0)
      longest = straight_nm + options_.max_detour_mm * kNmPerMm;
    if (options_.max_detour_ratio > 0)
      longest = std::min(longest, straight_nm * (1 + options_.max_detour_ratio));
    return longest;
  }

  std::vector<Point> Around(Point from, Point to, WorkBudget& budget) {
    return ways_->Find(from, to, Longest(Distance(from, to)), budget)
        .value_or(std::vector<Point>{});
  }

  bool IsHidden(Point from, Point to, const Travel& travel, size_t i) const {
    double length = 0;
    std::vector<Point> places = travel.corners;
    places.push_back(to);
    for (const Point place : places) {
      if (edge_.Meets(from, place) || walls_.Crosses(from, place)) return false;
      if (tops_.Crosses(from, place, static_cast<uint32_t>(i))) return false;
      length += Distance(from, place);
      from = place;
    }
    const double longest = options_.longest_hidden_mm * kNmPerMm;
    if (longest > 0 && length > longest) return false;
    // It meets no edge: if one of its places is inside, all of it is.
    return edge_.Surrounds(to);
  }

  const PolygonWithHoles& outline_;
  std::span<const Path> paths_;
  const TravelOptions& options_;
  EdgeStrips edge_;
  EdgeStrips walls_;
  EdgeStrips tops_;
  std::optional<InsideWays> ways_;
};

}  // namespace

std::vector<Travel> TravelsInIsland(const PolygonWithHoles& outline, std::span<const Path> paths,
                                    const TravelOptions& options, WorkBudget& budget) {
  std::vector<Travel> travels(paths.size());
  if (outline.outer.empty() || paths.size() < 2) return travels;
  if (!options.hide && !options.avoid_crossing) return travels;
  IslandTravels island(outline, paths, options);
  for (size_t i = 1; i < paths.size(); ++i) travels[i] = island.To(i, budget);
  return travels;
}

}  // namespace slicefarm::ordering
