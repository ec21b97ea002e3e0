#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "common/model/options/sequence_options.h"
#include "common/stage/stages.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm::planning {

/// Gives each printed copy a pass of its own, in the order of PrintSequence, for complete_objects.
/// The input of PrintSequence is the hulls of the copies with their supports, and the objects'
/// heights. Structures that planning adds to the plate (brims, rafts and skirts) are printed in the
/// first pass, before any copy.
///
/// Errors of Finish: any error of PrintSequence, with the objects' names and the numbers of the
/// copies; REQUEST_TOO_LARGE if all copies together have more than kMaxLayerPrograms layers. Cost:
/// see PrintSequence; it is too short to need cancellation. Memory: O(objects).
class SequencePlanner : public Planner {
 public:
  /// All arguments must outlive this planner. `object_names`: names for messages, indexed by
  /// object; may have fewer entries than objects.
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
  /// Returns the footprint of a copy, including its supports.
  Polygon FootprintOf(const PlacedCopy& copy, std::span<const AddedStack> added) const;

  const SequencePlanOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const std::span<const std::string> object_names_;
  /// top height and number of layers of each object's part, without supports and rafts; indexed by
  /// object, from the layers that Look has received
  std::map<int32_t, Printed> printed_;
};

}  // namespace slicefarm::planning
