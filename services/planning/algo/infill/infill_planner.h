#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>

#include "services/planning/algo/infill/infill_areas.h"
#include "services/planning/algo/infill/object_stack.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans the properties of infill that depend on many layers, for each object and each
/// region with one of these settings.
///   fill_pattern = auto: the pattern (choose_pattern.h).
///   fill_pattern = adaptivecubic, supportcubic: lines of an octree (cubic_octree.h).
///   fill_pattern = lightning: lines that grow down from tops (lightning.h).
///   infill_only_where_needed, infill_every_layers: areas (infill_areas.h).
///   separated_infills, center_of_surface_pattern = each_model: middles of bodies (bodies.h).
/// Each layer's plan gets the result, in the object's own coordinates.
///
/// Memory: the outlines of all layers of these objects.
class InfillPlanner : public Planner {
 public:
  /// `options` and `object_names` must outlive this planner. Region::settings is an index into
  /// `options.infill`. A region without a valid index is not planned.
  InfillPlanner(const PlanningOptions& options, std::span<const std::string> object_names)
      : options_(options), object_names_(object_names) {}

  /// Returns true if the infill options of some region need this planner.
  static bool IsNeeded(const PlanningOptions& options);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  int32_t Revise(OpenLayers& /*layers*/) override { return 0; }
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;
  int64_t HeldBytes() const override { return held_bytes_; }

 private:
  using Key = std::pair<int32_t, int32_t>;  ///< object, and index of the region settings

  void FinishRow(const Key& key, const ObjectStack& stack, OpenLayers& layers, JobPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const std::string> object_names_;
  int64_t held_bytes_ = 0;
  std::map<int32_t, ObjectStack> stacks_;  ///< layers per object; StackLayer::region is empty
  /// Outlines of each planned region; the inner key is the index of the layer in `stacks_`.
  std::map<Key, std::map<size_t, MultiPolygon>> regions_;
};

}  // namespace slicefarm::planning
