#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "common/model/options/sequence_options.h"
#include "common/stage/stages.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Gives each copy that prints something a pass of its own, in the order of PrintSequence: by the
/// hulls of the copies with their supports, and as high as the objects' outlines reach. What is
/// added to the plate stays in the first pass: brims, rafts and skirts lie before anything stands.
/// Errors of Finish: those of PrintSequence, with the objects' names and which copies they are;
/// REQUEST_TOO_LARGE if the copies have more than kMaxLayerPrograms layers together.
/// Cost: that of PrintSequence, too little to be cancelled. Memory: O(objects).
class SequencePlanner : public Planner {
 public:
  /// All must outlive this. `object_names`: by object; may be fewer.
  SequencePlanner(const SequencePlanOptions& options, std::span<const PlacedCopy> copies,
                  std::span<const std::string> object_names)
      : options_(options), copies_(copies), object_names_(object_names) {}

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  struct Printed {
    Coord top_nm = 0;
    int64_t layers = 0;
  };

  absl::Status CheckLayers() const;
  /// A copy's place with that of its supports.
  Polygon FootprintOf(const PlacedCopy& copy, std::span<const AddedStack> added) const;

  const SequencePlanOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const std::span<const std::string> object_names_;
  std::map<int32_t, Printed> printed_;  ///< by object
};

}  // namespace slicefarm::planning
