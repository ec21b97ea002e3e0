#include "services/beading/algo/local_beading_stage.h"

#include <utility>
#include <vector>

#include "common/model/bead_section.h"
#include "services/beading/algo/constant_walls.h"
#include "services/beading/algo/gap_fill.h"

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

absl::StatusOr<WalledIsland> BeadIsland(int32_t object, const PolygonWithHoles& outline,
                                        const WallPlan& plan, const GapFillOptions& gap_options,
                                        const CancelToken& cancel) {
  WalledIsland island;
  island.object = object;
  IslandWalls walls = MakeConstantWalls(outline, plan);
  AppendWalls(walls.centre_lines, plan, island.walls);
  auto gap_paths = FillGaps(walls.gaps, gap_options, cancel);
  if (!gap_paths.ok()) return gap_paths.status();
  for (Path& path : *gap_paths) island.walls.push_back(std::move(path));
  for (Path& path : island.walls) path.object = object;
  island.fill_area = std::move(walls.fill_area);
  return island;
}

class LocalBeading : public BeadingStage {
 public:
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const BeadingOptions& options) const override {
    std::vector<WalledLayer> walled;
    walled.reserve(neighbourhood.range.size());
    for (const SlicedLayer& layer : neighbourhood.layers) {
      if (!neighbourhood.range.Contains(layer.frame.index)) continue;
      if (absl::Status status = call.cancel.Check(); !status.ok()) return status;
      auto result = BeadLayer(layer, options, call.cancel);
      if (!result.ok()) return result.status();
      walled.push_back(*std::move(result));
    }
    return walled;
  }

 private:
  static absl::StatusOr<WalledLayer> BeadLayer(const SlicedLayer& layer,
                                               const BeadingOptions& options,
                                               const CancelToken& cancel) {
    const bool first = layer.frame.index == 0;
    const Coord height = layer.frame.height_nm;
    const Coord external = first ? options.first_layer_width_nm : options.external_width_nm;
    const Coord inner = first ? options.first_layer_width_nm : options.inner_width_nm;
    absl::Status status =
        CheckSpacing(first ? "first_layer_extrusion_width" : "external_perimeter_extrusion_width",
                     external, height);
    status.Update(CheckSpacing(first ? "first_layer_extrusion_width" : "perimeter_extrusion_width",
                               inner, height));
    if (!status.ok()) return status;

    WallPlan plan = WallPlan::Make(options.perimeters, external, inner, height);
    plan.gap_fill = options.gap_fill;
    plan.max_gap_width_nm = options.max_gap_width_nm;
    const GapFillOptions gap_options{options.min_gap_width_nm, options.max_gap_width_nm, height};
    WalledLayer walled;
    walled.frame = layer.frame;
    for (const ObjectSection& section : layer.objects) {
      for (const PolygonWithHoles& outline : section.outlines) {
        auto island = BeadIsland(section.object, outline, plan, gap_options, cancel);
        if (!island.ok()) return island.status();
        walled.islands.push_back(*std::move(island));
      }
    }
    return walled;
  }
};

}  // namespace

std::unique_ptr<BeadingStage> MakeLocalBeading() { return std::make_unique<LocalBeading>(); }

}  // namespace slicefarm::beading
