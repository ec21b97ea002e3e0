#include "services/beading/algo/local_beading_stage.h"

#include <optional>
#include <utility>
#include <vector>

#include "common/model/bead_section.h"
#include "common/model/settings.h"
#include "services/beading/algo/arachne/arachne_island.h"
#include "services/beading/algo/classic/classic_island.h"
#include "services/beading/algo/arachne/neighbour_outlines.h"

namespace slicefarm::beading {
namespace {

/// The walls of one layer.
class LayerWalls {
 public:
  /// Of the layer `index` of those that `neighbours` knows.
  LayerWalls(const BeadingOptions& options, const WallPlan& plan, const GapFillOptions& gap_options,
             const NeighbourOutlines& neighbours, size_t index)
      : plan_(plan), gap_options_(gap_options) {
    if (options.generator != WallGenerator::kArachne || plan.perimeters == 0) return;
    const auto band = static_cast<double>(options.transition_deviation_nm);
    arachne_.emplace(options, plan, gap_options,
                     [&neighbours, index, band](double x, double y, double radius_nm) {
                       return neighbours.MeanRadius(index, kBeadingHaloLayers, x, y, radius_nm,
                                                    band);
                     });
  }

  absl::StatusOr<WalledIsland> Make(const PolygonWithHoles& outline, const CancelToken& cancel,
                                    LayerFrame& frame) const {
    if (arachne_) {
      auto island = arachne_->Make(outline, cancel);
      if (!island.ok()) return island.status();
      if (*island) return **std::move(island);
      ++frame.plain_islands;
    }
    return MakeClassicIsland(outline, plan_, gap_options_, cancel);
  }

 private:
  WallPlan plan_;
  GapFillOptions gap_options_;
  std::optional<ArachneIslands> arachne_;
};

class LocalBeading : public BeadingStage {
 public:
  absl::StatusOr<std::vector<WalledLayer>> Bead(const StageCall& call,
                                                const Neighbourhood& neighbourhood,
                                                const BeadingOptions& options) const override {
    std::vector<WalledLayer> walled;
    walled.reserve(neighbourhood.range.size());
    const NeighbourOutlines neighbours(neighbourhood.layers);
    for (size_t i = 0; i < neighbourhood.layers.size(); ++i) {
      const SlicedLayer& layer = neighbourhood.layers[i];
      if (!neighbourhood.range.Contains(layer.frame.index)) continue;
      if (absl::Status status = call.cancel.Check(); !status.ok()) return status;
      auto result = BeadLayer(neighbours, i, layer, options, call.cancel);
      if (!result.ok()) return result.status();
      walled.push_back(*std::move(result));
    }
    return walled;
  }

 private:
  static absl::StatusOr<WalledLayer> BeadLayer(const NeighbourOutlines& neighbours, size_t index,
                                               const SlicedLayer& layer,
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
    plan.thin_walls = options.thin_walls || options.generator == WallGenerator::kArachne;
    plan.max_gap_width_nm = options.max_gap_width_nm;
    const GapFillOptions gap_options{options.min_gap_width_nm, options.max_gap_width_nm, height};
    const LayerWalls walls(options, plan, gap_options, neighbours, index);
    WalledLayer walled;
    walled.frame = layer.frame;
    for (const ObjectSection& section : layer.objects) {
      for (const PolygonWithHoles& outline : section.outlines) {
        auto island = walls.Make(outline, cancel, walled.frame);
        if (!island.ok()) return island.status();
        island->object = section.object;
        for (Path& path : island->walls) path.object = section.object;
        walled.islands.push_back(*std::move(island));
      }
    }
    return walled;
  }
};

}  // namespace

std::unique_ptr<BeadingStage> MakeLocalBeading() { return std::make_unique<LocalBeading>(); }

}  // namespace slicefarm::beading
