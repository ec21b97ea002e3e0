#include "services/planning/algo/supports/generator/small_overhangs.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "common/base/disjoint_sets.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/measure.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/support_options.h"

namespace slicefarm::planning {
namespace {

/// Half of the width of the widest small overhang, in walls.
constexpr double kSmallHalfWalls = 1;
/// Area that may remain of a small overhang after it is inset by this width, in nm^2.
constexpr double kSmallRestNm2 = 0.01e12;
/// Reach of an overhang beyond the layer below that is not small.
constexpr Coord kLongReachNm = 3'000'000;

/// Steep area of one layer.
struct SteepArea {
  size_t layer = 0;
  const PolygonWithHoles* island = nullptr;
  Box box;
};

class SmallOverhangs {
 public:
  SmallOverhangs(const SupportProblem& problem, const SupportOptions& options,
                 std::vector<Overhang>& overhangs)
      : problem_(problem), options_(options), overhangs_(overhangs) {
    for (size_t layer = 0; layer < overhangs.size(); ++layer) {
      begin_.push_back(areas_.size());
      for (const PolygonWithHoles& island : overhangs[layer].steep)
        areas_.push_back({layer, &island, Bounds(island.outer)});
    }
    begin_.push_back(areas_.size());
  }

  void Remove() {
    DisjointSets groups(static_cast<int32_t>(areas_.size()));
    for (size_t layer = 1; layer < overhangs_.size(); ++layer) JoinWithBelow(layer, groups);
    std::map<int32_t, std::vector<size_t>> members;
    for (size_t i = 0; i < areas_.size(); ++i)
      members[groups.RootOf(static_cast<int32_t>(i))].push_back(i);
    std::vector<MultiPolygon> kept(overhangs_.size());
    std::vector<char> changed(overhangs_.size(), 0);
    for (const auto& [group, all] : members) {
      const bool small = IsSmall(all);
      for (const size_t i : all) {
        const SteepArea& area = areas_[i];
        if (small) {
          changed[area.layer] = 1;
        } else {
          kept[area.layer].push_back(*area.island);
        }
      }
    }
    for (size_t layer = 0; layer < overhangs_.size(); ++layer)
      if (changed[layer] != 0)
        KeepSteep(problem_, layer, options_, std::move(kept[layer]), overhangs_[layer]);
  }

 private:
  void JoinWithBelow(size_t layer, DisjointSets& groups) {
    for (size_t i = begin_[layer]; i < begin_[layer + 1]; ++i) {
      const Box near = areas_[i].box.Grown(options_.wall_width_nm);
      MultiPolygon grown;
      for (size_t j = begin_[layer - 1]; j < begin_[layer]; ++j) {
        if (!near.Intersects(areas_[j].box)) continue;
        if (grown.empty()) grown = FastOffset({*areas_[i].island}, options_.wall_width_nm);
        if (!Intersection(grown, {*areas_[j].island}).empty())
          groups.Join(static_cast<int32_t>(i), static_cast<int32_t>(j));
      }
    }
  }

  bool IsSmall(const std::vector<size_t>& members) const {
    MultiPolygon merged;
    for (const size_t i : members) merged = Union(merged, {*areas_[i].island});
    // The steps of a slope have gaps between them, as wide as an overhang without support.
    const Coord closing = options_.wall_width_nm / 2;
    const Coord half = std::llround(kSmallHalfWalls * static_cast<double>(options_.wall_width_nm));
    if (Area(FastOffset(FastOffset(merged, closing), -(closing + half))) > kSmallRestNm2)
      return false;
    return std::ranges::none_of(members, [this](size_t i) { return IsNeeded(areas_[i]); });
  }

  /// Returns true if an area needs support although it is small.
  bool IsNeeded(const SteepArea& area) const {
    const MultiPolygon island = {*area.island};
    if (static_cast<int32_t>(area.layer) < options_.enforced_layers) return true;
    const MultiPolygon* enforcers = problem_.part[area.layer].enforcers;
    if (enforcers != nullptr && !Intersection(island, *enforcers).empty()) return true;
    if (!Intersection(island, IslandsInAirOf(problem_, area.layer)).empty()) return true;
    const MultiPolygon& below = *problem_.part[area.layer - 1].outlines;
    return !Difference(island, FastOffset(below, kLongReachNm)).empty();
  }

  const SupportProblem& problem_;
  const SupportOptions& options_;
  std::vector<Overhang>& overhangs_;
  std::vector<SteepArea> areas_;  ///< sorted by layer
  std::vector<size_t> begin_;     ///< index of each layer's first area
};

}  // namespace

void RemoveSmallOverhangs(const SupportProblem& problem, const SupportOptions& options,
                          std::vector<Overhang>& overhangs) {
  SmallOverhangs(problem, options, overhangs).Remove();
}

}  // namespace slicefarm::planning
