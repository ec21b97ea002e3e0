#include "services/planning/algo/supports/generator/branch_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/parallel.h"
#include "common/base/portable_math.h"
#include "common/geometry/boolean/boolean.h"
#include "common/geometry/offset/clean_offset.h"
#include "common/model/options/support_options.h"
#include "services/planning/algo/supports/generator/branch_necks.h"

namespace slicefarm::planning {
namespace {

/// Smallest increase of a branch's radius at its foot, and the height of the foot.
constexpr Coord kFootWiderNm = 600'000;
constexpr Coord kFootHeightNm = 1'200'000;

/// Distance of a neck from the part above it, in addition to the support's gap. Necks do not
/// support the part, and a surface slightly below the gap would only be hard to remove.
constexpr Coord kBelowPartNm = 450'000;

/// Returns a polygon with the same area as the disc. The circle is half inside and half outside of
/// it.
Polygon Circle(const BranchDisc& disc) {
  const int corners = disc.radius_nm < 700'000 ? 16 : disc.radius_nm < 2'000'000 ? 24 : 36;
  Polygon ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.5) / corners;
    ring.push_back({disc.at.x + std::llround(disc.radius_nm * Cos(angle)),
                    disc.at.y + std::llround(disc.radius_nm * Sin(angle))});
  }
  return ring;
}

Coord FootRadius(Coord radius_nm, Coord z_nm) {
  if (z_nm >= kFootHeightNm) return radius_nm;
  const Coord foot = std::max(kFootRadiusNm, radius_nm + kFootWiderNm);
  return foot - (foot - radius_nm) * z_nm / kFootHeightNm;
}

/// Widens discs near the bed to feet, as far as there is free space, and at most by half the
/// distance to the next disc. Feet must not merge into one outline: the branches inside it would
/// have nothing below them.
void GrowFeet(Coord z_nm, const ReachField& field, std::vector<BranchDisc>& discs) {
  const std::vector<BranchDisc> bare = discs;
  for (BranchDisc& disc : discs) {
    const Coord radius = disc.radius_nm;
    Coord foot = std::min(FootRadius(radius, z_nm), field.ToAnywhere(0, disc.at));
    for (const BranchDisc& other : bare) {
      const auto free = std::llround(Distance(disc.at, other.at)) - radius - other.radius_nm;
      if (free >= 0) foot = std::min<Coord>(foot, radius + free / 2);
    }
    disc.radius_nm = std::max(radius, foot);
  }
}

/// Returns the discs of all branches by layer.
std::vector<std::vector<BranchDisc>> DiscsByLayer(const Branches& branches, const ReachField& field,
                                                  const SupportHeights& heights) {
  std::vector<std::vector<BranchDisc>> discs(heights.layers.size());
  const auto middle = [&](size_t i) {
    return (heights.layers[i].bottom_nm + heights.layers[i].top_nm) / 2;
  };
  for (const BranchNode& node : branches.nodes) {
    const bool goes_on = node.below >= 0;
    const BranchNode& end = goes_on ? branches.nodes[static_cast<size_t>(node.below)] : node;
    const Coord down_to = goes_on ? end.z_nm : node.foot_nm;
    const auto above = std::partition_point(
        heights.layers.begin(), heights.layers.end(), [&](const SupportHeight& layer) {
          return (layer.bottom_nm + layer.top_nm) / 2 < node.z_nm;
        });
    for (auto i = static_cast<size_t>(above - heights.layers.begin());
         i-- > 0 && middle(i) >= down_to;) {
      const double share =
          goes_on ? static_cast<double>(node.z_nm - middle(i)) / (node.z_nm - end.z_nm) : 0;
      discs[i].push_back({{node.at.x + std::llround((end.at.x - node.at.x) * share),
                           node.at.y + std::llround((end.at.y - node.at.y) * share)},
                          node.radius_nm + std::llround((end.radius_nm - node.radius_nm) * share)});
    }
  }
  for (size_t i = 0; i < discs.size() && heights.layers[i].bottom_nm < kFootHeightNm; ++i)
    GrowFeet(heights.layers[i].bottom_nm, field, discs[i]);
  return discs;
}

/// Returns true if the part is too far away to cut the disc.
bool IsClear(const BranchDisc& disc, const ReachField& field, size_t slab) {
  // Between two slabs a branch is up to one step away from a place that the field has checked.
  return field.ToAnywhere(slab, disc.at) > disc.radius_nm + 3 * field.grid().pixel_nm;
}

/// Returns the area of a layer's discs and the necks between them, cut to the free area.
MultiPolygon SectionOf(const std::vector<BranchDisc>& discs, const ReachField& field, size_t slab,
                       const SupportHeight& height, const Clearance& clearance) {
  const size_t above = std::min(slab + 1, field.slabs().size() - 1);
  const auto is_clear = [&](const BranchDisc& disc) { return IsClear(disc, field, slab); };
  const auto is_clear_above = [&](const BranchDisc& disc) { return IsClear(disc, field, above); };
  std::vector<Polygon> near, near_necks, far;
  for (const BranchDisc& disc : discs) (is_clear(disc) ? far : near).push_back(Circle(disc));
  for (const auto& [i, k] : NecksBetween(discs)) {
    const BranchDisc &a = discs[i], &b = discs[k];
    const bool is_far = is_clear(a) && is_clear(b) && is_clear_above(a) && is_clear_above(b);
    (is_far ? far : near_necks).push_back(OutlineOfNeck(a, b));
  }
  MultiPolygon all = clearance.FreeOf(near, height.bottom_nm, height.top_nm);
  if (!near_necks.empty())
    all = Union(all, clearance.FreeOf(near_necks, height.bottom_nm, height.top_nm + kBelowPartNm));
  if (far.empty()) return all;
  MultiPolygon whole = Union(far, FillRule::kNonZero);
  return all.empty() ? whole : Union(all, whole);
}

/// Returns true if some part of the island is wide enough for a second loop.
bool IsThick(const PolygonWithHoles& island, Coord diameter_nm) {
  const double diameter = static_cast<double>(diameter_nm);
  return Area(island) >= std::numbers::pi * diameter * diameter / 4 &&
         !FastOffset({island}, -diameter_nm * 24 / 50).empty();
}

}  // namespace

std::vector<BranchSections> DrawBranches(const Branches& branches, const ReachField& field,
                                         const SupportHeights& heights, const Clearance& clearance,
                                         const SupportOptions& options, int threads,
                                         const CancelToken& cancel) {
  std::vector<std::vector<BranchDisc>> discs = DiscsByLayer(branches, field, heights);
  std::vector<size_t> slab_of(heights.layers.size(), 0);
  for (size_t s = 0; s < field.slabs().size(); ++s)
    for (int32_t i = field.slabs()[s].first_layer; i <= field.slabs()[s].last_layer; ++i)
      slab_of[static_cast<size_t>(i)] = s;
  std::vector<BranchSections> sections(discs.size());
  ForEachIndex(threads, discs.size(), [&](size_t i, int) {
    if (discs[i].empty() || cancel.Cancelled()) return;
    std::sort(discs[i].begin(), discs[i].end());
    MultiPolygon all = SectionOf(discs[i], field, slab_of[i], heights.layers[i], clearance);
    for (PolygonWithHoles& island : all) {
      const bool is_thick = IsThick(island, options.tree.double_wall_diameter_nm);
      (is_thick ? sections[i].thick : sections[i].thin).push_back(std::move(island));
    }
  });
  return sections;
}

}  // namespace slicefarm::planning
