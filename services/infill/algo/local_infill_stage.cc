#include "services/infill/algo/local_infill_stage.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "services/infill/algo/rectilinear.h"
#include "services/infill/algo/skins.h"
#include "services/infill/algo/solid.h"

namespace slicefarm::infill {
namespace {

const MultiPolygon* OutlinesOf(const SlicedLayer& layer, int32_t object) {
  for (const ObjectSection& section : layer.objects)
    if (section.object == object) return &section.outlines;
  return nullptr;
}

/// Looks layers up by index.
class Surroundings {
 public:
  explicit Surroundings(const Neighbourhood& neighbourhood) : neighbourhood_(neighbourhood) {}

  /// The outlines of an object in a layer; nullptr: air.
  const MultiPolygon* Outlines(int32_t index, int32_t object) const {
    if (neighbourhood_.layers.empty()) return nullptr;
    const int32_t at = index - neighbourhood_.layers.front().frame.index;
    if (at < 0 || at >= static_cast<int32_t>(neighbourhood_.layers.size())) return nullptr;
    return OutlinesOf(neighbourhood_.layers[at], object);
  }

  Cover CoverOf(int32_t index, int32_t object, const InfillOptions& options) const {
    Cover cover;
    cover.on_bed = index == 0;
    for (int32_t i = 1; i <= options.top_solid_layers; ++i)
      cover.above.push_back(Outlines(index + i, object));
    for (int32_t i = 1; i <= options.bottom_solid_layers; ++i)
      cover.below.push_back(Outlines(index - i, object));
    return cover;
  }

 private:
  const Neighbourhood& neighbourhood_;
};

/// Fills the islands of one layer.
class LayerFill {
 public:
  LayerFill(const LayerFrame& frame, const InfillOptions& options)
      : frame_(frame), options_(options) {}

  absl::StatusOr<FilledIsland> Fill(WalledIsland walled, const MultiPolygon& outline,
                                    const Cover& cover) const {
    const Skins skins = PartFillArea(walled.fill_area, outline, cover,
                                     {.width_nm = Width(options_.solid_width_nm),
                                      .solid_below_area_mm2 = options_.solid_below_area_mm2,
                                      .all_solid = options_.density >= 1});
    FilledIsland filled;
    filled.object = walled.object;
    filled.walls = std::move(walled.walls);
    const SolidPattern inner = cover.on_bed ? options_.bottom_pattern : options_.solid_pattern;
    absl::Status status = AppendSolid(skins.top, Feature::kTopSolidInfill, options_.top_pattern,
                                      options_.top_width_nm, filled.fills);
    if (status.ok())
      status = AppendSolid(skins.bridge, Feature::kBridgeInfill, options_.bottom_pattern,
                           options_.solid_width_nm, filled.fills);
    if (status.ok())
      status = AppendSolid(skins.solid, Feature::kSolidInfill, inner, options_.solid_width_nm,
                           filled.fills);
    if (status.ok()) status = AppendSparse(skins.sparse, filled.fills);
    if (!status.ok()) return status;
    for (FillGroup& group : filled.fills)
      for (Path& path : group.paths) path.object = filled.object;
    return filled;
  }

 private:
  Coord Width(Coord width_nm) const {
    return frame_.index == 0 ? options_.first_layer_width_nm : width_nm;
  }

  absl::Status AppendSolid(const MultiPolygon& regions, Feature feature, SolidPattern pattern,
                           Coord width_nm, std::vector<FillGroup>& fills) const {
    for (const PolygonWithHoles& region : regions) {
      auto group = FillSolid(region, {.feature = feature,
                                      .pattern = pattern,
                                      .angle_rad = options_.angle_rad,
                                      .layer_index = frame_.index,
                                      .width_nm = Width(width_nm),
                                      .height_nm = frame_.height_nm,
                                      .overlap_nm = options_.overlap_nm});
      if (!group.ok()) return group.status();
      if (!group->paths.empty()) fills.push_back(*std::move(group));
    }
    return absl::OkStatus();
  }

  absl::Status AppendSparse(const MultiPolygon& region, std::vector<FillGroup>& fills) const {
    auto paths = FillSparse(region, {.pattern = options_.pattern,
                                     .density = options_.density,
                                     .angle_rad = options_.angle_rad,
                                     .layer_index = frame_.index,
                                     .width_nm = Width(options_.sparse_width_nm),
                                     .height_nm = frame_.height_nm,
                                     .overlap_nm = options_.overlap_nm});
    if (!paths.ok()) return paths.status();
    if (!paths->empty()) fills.push_back({false, *std::move(paths)});
    return absl::OkStatus();
  }

  const LayerFrame& frame_;
  const InfillOptions& options_;
};

class LocalInfill : public InfillStage {
 public:
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                const InfillOptions& options) const override {
    const Surroundings surroundings(neighbourhood);
    std::vector<FilledLayer> layers;
    layers.reserve(walled.size());
    for (WalledLayer& layer : walled) {
      if (absl::Status status = call.cancel.Check(); !status.ok()) return status;
      auto filled = FillLayer(std::move(layer), surroundings, options);
      if (!filled.ok()) return filled.status();
      layers.push_back(*std::move(filled));
    }
    return layers;
  }

 private:
  static absl::StatusOr<FilledLayer> FillLayer(WalledLayer walled, const Surroundings& surroundings,
                                               const InfillOptions& options) {
    FilledLayer layer;
    layer.frame = walled.frame;
    layer.islands.reserve(walled.islands.size());
    const LayerFill fill(layer.frame, options);
    for (WalledIsland& island : walled.islands) {
      const int32_t object = island.object;
      const MultiPolygon* outline = surroundings.Outlines(layer.frame.index, object);
      const Cover cover = surroundings.CoverOf(layer.frame.index, object, options);
      auto filled = fill.Fill(std::move(island), outline ? *outline : MultiPolygon{}, cover);
      if (!filled.ok()) return filled.status();
      layer.islands.push_back(*std::move(filled));
    }
    return layer;
  }
};

}  // namespace

std::unique_ptr<InfillStage> MakeLocalInfill() { return std::make_unique<LocalInfill>(); }

}  // namespace slicefarm::infill
