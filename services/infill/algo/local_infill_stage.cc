#include "services/infill/algo/local_infill_stage.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "common/model/bead_section.h"
#include "services/infill/algo/bridge_angle.h"
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
    return {.above = Side(index, object, 1, options.top_solid_layers),
            .below = Side(index, object, -1, options.bottom_solid_layers),
            .on_bed = index == 0};
  }

 private:
  /// In a prism all layers are equal: that is found out here, once for all islands.
  std::vector<const MultiPolygon*> Side(int32_t index, int32_t object, int32_t step,
                                        int32_t count) const {
    std::vector<const MultiPolygon*> side;
    const MultiPolygon* const own = Outlines(index, object);
    const MultiPolygon* nearer = own;
    for (int32_t i = 1; i <= count; ++i) {
      const MultiPolygon* layer = Outlines(index + i * step, object);
      for (const MultiPolygon* same : {own, nearer})
        if (same != nullptr && layer != nullptr && *layer == *same) layer = same;
      side.push_back(layer);
      nearer = layer;
    }
    return side;
  }

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
    if (status.ok()) status = AppendBridges(skins.bridge, cover, filled.fills);
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

  /// Solid lines turn by a right angle from layer to layer.
  double SolidAngle() const {
    return options_.angle_rad + (frame_.index % 2 != 0 ? std::numbers::pi / 2 : 0);
  }

  absl::Status AppendSolid(const MultiPolygon& regions, Feature feature, SolidPattern pattern,
                           Coord width_nm, std::vector<FillGroup>& fills) const {
    for (const PolygonWithHoles& region : regions) {
      const absl::Status status =
          AppendSolidRegion(region, feature, pattern, SolidAngle(), width_nm, fills);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  /// Each bridge in the direction in which it is borne best.
  absl::Status AppendBridges(const MultiPolygon& regions, const Cover& cover,
                             std::vector<FillGroup>& fills) const {
    const MultiPolygon* below = cover.below.empty() ? nullptr : cover.below[0];
    for (const PolygonWithHoles& region : regions) {
      const auto angle =
          below == nullptr ? std::nullopt : BridgeAngle(region, *below, options_.solid_width_nm);
      const absl::Status status =
          AppendSolidRegion(region, Feature::kBridgeInfill, options_.bottom_pattern,
                            angle.value_or(SolidAngle()), options_.solid_width_nm, fills);
      if (!status.ok()) return status;
    }
    return absl::OkStatus();
  }

  absl::Status AppendSolidRegion(const PolygonWithHoles& region, Feature feature,
                                 SolidPattern pattern, double angle_rad, Coord width_nm,
                                 std::vector<FillGroup>& fills) const {
    auto group = FillSolid(region, {.feature = feature,
                                    .pattern = pattern,
                                    .angle_rad = angle_rad,
                                    .width_nm = Width(width_nm),
                                    .height_nm = frame_.height_nm,
                                    .overlap_nm = options_.overlap_nm});
    if (!group.ok()) return group.status();
    if (!group->paths.empty()) fills.push_back(*std::move(group));
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
  /// Lines less than nothing apart would be infinitely many.
  static absl::Status CheckWidths(const LayerFrame& frame, const InfillOptions& options) {
    if (frame.index == 0) {
      return CheckSpacing("first_layer_extrusion_width", options.first_layer_width_nm,
                          frame.height_nm);
    }
    absl::Status status =
        CheckSpacing("solid_infill_extrusion_width", options.solid_width_nm, frame.height_nm);
    status.Update(
        CheckSpacing("top_infill_extrusion_width", options.top_width_nm, frame.height_nm));
    if (options.density > 0) {
      status.Update(
          CheckSpacing("infill_extrusion_width", options.sparse_width_nm, frame.height_nm));
    }
    return status;
  }

  static absl::StatusOr<FilledLayer> FillLayer(WalledLayer walled, const Surroundings& surroundings,
                                               const InfillOptions& options) {
    if (absl::Status status = CheckWidths(walled.frame, options); !status.ok()) return status;
    FilledLayer layer;
    layer.frame = walled.frame;
    layer.islands.reserve(walled.islands.size());
    const LayerFill fill(layer.frame, options);
    const MultiPolygon none;
    std::map<int32_t, Cover> covers;  // of objects
    for (WalledIsland& island : walled.islands) {
      const int32_t object = island.object;
      const auto [cover, is_new] = covers.try_emplace(object);
      if (is_new) cover->second = surroundings.CoverOf(layer.frame.index, object, options);
      const MultiPolygon* outline = surroundings.Outlines(layer.frame.index, object);
      auto filled = fill.Fill(std::move(island), outline ? *outline : none, cover->second);
      if (!filled.ok()) return filled.status();
      layer.islands.push_back(*std::move(filled));
    }
    return layer;
  }
};

}  // namespace

std::unique_ptr<InfillStage> MakeLocalInfill() { return std::make_unique<LocalInfill>(); }

}  // namespace slicefarm::infill
