#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "services/planning/algo/infill/infill_places.h"
#include "services/planning/algo/infill/object_stack.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Decides what of the sparse infill depends on more layers than a few, for each object and each
/// region's settings that ask for it:
///   fill_pattern = auto                       which pattern it is (choose_pattern.h)
///   adaptivecubic, supportcubic               lines of an octree (cubic_octree.h)
///   lightning                                 lines that hang from tops (lightning.h)
///   infill_only_where_needed, infill_every_layers    places (infill_places.h)
/// What is decided for a layer is in its plan, in the object's own coordinates.
///
/// Memory: the outlines of all layers of those objects.
class InfillPlanner : public Planner {
 public:
  /// `options` and `object_names` must outlive this. Sections name rows of `options.infill`; what
  /// names none is not planned.
  InfillPlanner(const PlanningOptions& options, std::span<const std::string> object_names)
      : options_(options), object_names_(object_names) {}

  /// Whether there is anything to decide.
  static bool IsNeeded(const PlanningOptions& options);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  int32_t Settle(OpenLayers& /*layers*/) override { return 0; }
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;
  int64_t HeldBytes() const override { return held_bytes_; }

 private:
  using Key = std::pair<int32_t, int32_t>;  ///< object, row

  void FinishRow(const Key& key, const ObjectStack& stack, OpenLayers& layers, JobPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const std::string> object_names_;
  int64_t held_bytes_ = 0;
  std::map<int32_t, ObjectStack> stacks_;                  ///< by object; `region` is not filled in
  std::map<Key, std::map<size_t, MultiPolygon>> regions_;  ///< by place in the object's stack
};

}  // namespace slicefarm::planning
