#include "services/beading/algo/local_beading_stage.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/model/layers/region_check.h"
#include "common/model/options/beading_options.h"
#include "services/beading/algo/section_walls.h"

namespace slicefarm::beading {
namespace {

/// Outlines of one stack in consecutive layers.
struct StackOutlines {
  std::vector<const MultiPolygon*> layers;
  std::optional<NeighbourOutlines> neighbours;
};

/// Layers around each section, per stack.
class Surroundings {
 public:
  explicit Surroundings(std::span<const SlicedLayer> layers) {
    for (const SlicedLayer& layer : layers) {
      for (const ObjectSection& section : layer.sections) {
        StackOutlines& stack = stacks_[section.stack.id];
        index_[&section] = stack.layers.size();
        stack.layers.push_back(&OutlineOf(section));
      }
    }
    for (auto& [id, stack] : stacks_) stack.neighbours.emplace(std::move(stack.layers));
  }

  SectionContext ContextOf(const SlicedLayer& layer, const ObjectSection& section,
                           IslandMemo& memo) const {
    return {section, layer.frame.index == 0, *stacks_.at(section.stack.id).neighbours,
            index_.at(&section), &memo};
  }

 private:
  std::map<int32_t, StackOutlines> stacks_;       ///< stack id -> outlines
  std::map<const ObjectSection*, size_t> index_;  ///< index of a section in its stack
};

class LocalBeading : public BeadingStage {
 public:
  absl::StatusOr<std::vector<WalledLayer>> Bead(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<BeadingTable>& regions) const override {
    std::vector<WalledLayer> walled;
    walled.reserve(static_cast<size_t>(neighbourhood.range.size()));
    const Surroundings surroundings(neighbourhood.layers);
    IslandMemo memo;
    for (const SlicedLayer& layer : neighbourhood.layers) {
      if (!neighbourhood.range.Contains(layer.frame.index)) continue;
      auto result = WallLayer(layer, surroundings, *regions, call.cancel, memo);
      if (!result.ok()) return result.status();
      walled.push_back(*std::move(result));
      memo.NextLayer();
    }
    return walled;
  }

 private:
  static absl::StatusOr<WalledLayer> WallLayer(const SlicedLayer& layer,
                                               const Surroundings& surroundings,
                                               std::span<const BeadingOptions> regions,
                                               const CancelToken& cancel, IslandMemo& memo) {
    if (absl::Status ok = CheckRegions(layer, regions.size()); !ok.ok()) return ok;
    WalledLayer walled;
    walled.frame = layer.frame;
    for (const ObjectSection& section : layer.sections) {
      if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
      auto result = WallSection(surroundings.ContextOf(layer, section, memo), regions, cancel);
      if (!result.ok()) return result.status();
      walled.plain_islands += result->plain_islands;
      walled.sections.push_back(std::move(result->walled));
    }
    return walled;
  }
};

}  // namespace

std::unique_ptr<BeadingStage> MakeLocalBeading() { return std::make_unique<LocalBeading>(); }

}  // namespace slicefarm::beading
