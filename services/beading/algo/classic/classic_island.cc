#include "services/beading/algo/classic/classic_island.h"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace slicefarm::beading {
namespace {

void AppendWalls(const std::vector<MultiPolygon>& centre_lines, const WallPlan& plan,
                 std::vector<Path>& paths) {
  for (size_t inset = 0; inset < centre_lines.size(); ++inset) {
    for (const PolygonWithHoles& rings : centre_lines[inset]) {
      const auto append = [&](const Polygon& ring) {
        Path& path = paths.emplace_back();
        path.feature = inset == 0 ? Feature::kExternalPerimeter : Feature::kPerimeter;
        path.inset = static_cast<int32_t>(inset);
        path.closed = true;
        path.points = ring;
        path.widths_nm = {inset == 0 ? plan.external_width_nm : plan.inner_width_nm};
      };
      append(rings.outer);
      for (const Polygon& hole : rings.holes) append(hole);
    }
  }
}

/// Removes beads in tips that are not worth a travel, if the island has walls.
void DropTips(const WallPlan& plan, size_t walls, std::vector<Path>& beads) {
  if (walls == 0 || plan.least_tip_nm == 0) return;
  std::erase_if(beads, [&](const Path& bead) {
    return PathLength(bead) < static_cast<double>(plan.least_tip_nm);
  });
}

}  // namespace

absl::StatusOr<IslandBeads> MakeClassicIsland(const PolygonWithHoles& outline, const WallPlan& plan,
                                              const GapFillOptions& gap_options,
                                              const CancelToken& cancel) {
  IslandBeads island;
  IslandWalls walls = MakeConstantWalls(outline, plan);
  AppendWalls(walls.centre_lines, plan, island.walls);
  island.fill_area = std::move(walls.fill_area);
  auto gap_paths = FillGaps(walls.gaps, gap_options, cancel);
  if (!gap_paths.ok()) return gap_paths.status();
  DropTips(plan, island.walls.size(), *gap_paths);
  std::ranges::move(*gap_paths, std::back_inserter(island.walls));
  if (!plan.gap_fill || plan.perimeters == 0) return island;
  auto narrow_paths = FillNarrowParts(gap_options, cancel, island.fill_area);
  if (!narrow_paths.ok()) return narrow_paths.status();
  std::ranges::move(*narrow_paths, std::back_inserter(island.walls));
  return island;
}

}  // namespace slicefarm::beading
