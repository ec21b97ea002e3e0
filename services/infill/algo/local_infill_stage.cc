#include "services/infill/algo/local_infill_stage.h"

#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/model/layers/region_check.h"
#include "common/model/options/infill_options.h"
#include "common/stage/object_layers.h"
#include "services/infill/algo/section_fill.h"

namespace slicefarm::infill {
namespace {

absl::Status CheckAreas(const WalledLayer& layer, size_t rows) {
  for (const WalledSection& section : layer.sections)
    for (const WalledIsland& island : section.islands)
      for (const FillArea& area : island.fill_areas)
        if (absl::Status ok = CheckRegion(area.settings, area.tool, rows, layer.frame); !ok.ok())
          return ok;
  return absl::OkStatus();
}

absl::Status NoPlans() {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   "the plans are not one for each layer", {{"field", "plans"}});
}

class LocalInfill : public InfillStage {
 public:
  absl::StatusOr<std::vector<FilledLayer>> Fill(const StageCall& call,
                                                std::vector<WalledLayer> walled,
                                                const Neighbourhood& neighbourhood,
                                                std::span<const LayerPlan> plans,
                                                const Shared<InfillTable>& regions) const override {
    if (plans.size() != walled.size()) return NoPlans();
    const ObjectLayers objects(neighbourhood.layers);
    const absl::StatusOr<FieldsOfRows>& parsed = regions.Once(ParseFields);
    if (!parsed.ok()) return parsed.status();
    RegionFields fields(*parsed, neighbourhood.layers);
    std::vector<FilledLayer> layers;
    layers.reserve(walled.size());
    for (size_t i = 0; i < walled.size(); ++i) {
      WalledLayer& layer = walled[i];
      const LayerPlan& plan = plans[i];
      if (absl::Status ok = CheckAreas(layer, regions->size()); !ok.ok()) return ok;
      FilledLayer& filled = layers.emplace_back();
      filled.frame = layer.frame;
      for (WalledSection& section : layer.sections) {
        if (absl::Status wanted = call.cancel.Check(); !wanted.ok()) return wanted;
        auto result = FillSection(std::move(section), layer.frame.index == 0, objects, plan,
                                  *regions, fields);
        if (!result.ok()) return result.status();
        filled.sections.push_back(*std::move(result));
      }
    }
    return layers;
  }
};

}  // namespace

std::unique_ptr<InfillStage> MakeLocalInfill() { return std::make_unique<LocalInfill>(); }

}  // namespace slicefarm::infill
