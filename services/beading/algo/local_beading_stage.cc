#include "services/beading/algo/local_beading_stage.h"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/model/region_check.h"
#include "services/beading/algo/section_walls.h"

namespace slicefarm::beading {
namespace {

/// The outlines of one object in a stretch of layers.
struct ObjectOutlines {
  std::vector<const MultiPolygon*> layers;
  std::optional<NeighbourOutlines> neighbours;
};

/// The layers around each section, by object. What lies on the plate besides the objects is no
/// stack of layers of one thing: each of its sections stands alone.
class Surroundings {
 public:
  explicit Surroundings(std::span<const SlicedLayer> layers) {
    for (const SlicedLayer& layer : layers) {
      for (const ObjectSection& section : layer.sections) {
        ObjectOutlines& object =
            section.object == kPlate ? alone_[&section] : objects_[section.object];
        index_[&section] = object.layers.size();
        object.layers.push_back(&OutlineOf(section));
      }
    }
    for (auto& [index, object] : objects_) object.neighbours.emplace(std::move(object.layers));
    for (auto& [section, object] : alone_) object.neighbours.emplace(std::move(object.layers));
  }

  SectionPlace PlaceOf(const SlicedLayer& layer, const ObjectSection& section) const {
    const ObjectOutlines& object =
        section.object == kPlate ? alone_.at(&section) : objects_.at(section.object);
    return {section, layer.frame.index == 0, *object.neighbours, index_.at(&section)};
  }

 private:
  std::map<int32_t, ObjectOutlines> objects_;
  std::map<const ObjectSection*, ObjectOutlines> alone_;
  std::map<const ObjectSection*, size_t> index_;  ///< of a section among its object's
};

class LocalBeading : public BeadingStage {
 public:
  absl::StatusOr<std::vector<WalledLayer>> Bead(
      const StageCall& call, const Neighbourhood& neighbourhood,
      const Shared<BeadingTable>& regions) const override {
    std::vector<WalledLayer> walled;
    walled.reserve(static_cast<size_t>(neighbourhood.range.size()));
    const Surroundings surroundings(neighbourhood.layers);
    for (const SlicedLayer& layer : neighbourhood.layers) {
      if (!neighbourhood.range.Contains(layer.frame.index)) continue;
      auto result = WallLayer(layer, surroundings, *regions, call.cancel);
      if (!result.ok()) return result.status();
      walled.push_back(*std::move(result));
    }
    return walled;
  }

 private:
  static absl::StatusOr<WalledLayer> WallLayer(const SlicedLayer& layer,
                                               const Surroundings& surroundings,
                                               std::span<const BeadingOptions> regions,
                                               const CancelToken& cancel) {
    if (absl::Status ok = CheckRegions(layer, regions.size()); !ok.ok()) return ok;
    WalledLayer walled;
    walled.frame = layer.frame;
    for (const ObjectSection& section : layer.sections) {
      if (absl::Status wanted = cancel.Check(); !wanted.ok()) return wanted;
      auto result = WallSection(surroundings.PlaceOf(layer, section), regions, cancel);
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
