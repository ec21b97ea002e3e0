#pragma once

#include <map>
#include <set>
#include <span>
#include <vector>

#include "common/model/options/planning_options.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/adhesion/raft.h"
#include "services/planning/algo/planner/region_planner.h"

namespace slicefarm::planning {

/// Puts rafts under objects that ask for one, and lifts what stands on them. An object that has
/// room around all of its copies has its own, which is printed and cancelled with each. Copies that
/// stand closer share one with those of equal options; what carries them is united. With
/// complete_objects all are shared: they lie before anything stands. A raft keeps 0.5 mm away from
/// objects that it does not carry, and from rafts of other options, of which the one of the earlier
/// object has the place. It carries supports as well as parts. Nothing lies outside of the bed.
///
/// Stacks of StackKind::kRaft, with regions of Role::kRaft and kRaftInterface. Errors: Cancelled,
/// polled for each raft.
class RaftPlanner : public RegionPlanner {
 public:
  /// `options` and `copies` must outlive this. Every copy's object has options.
  RaftPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
      : options_(options), copies_(copies) {}

  /// Whether some object asks for a raft.
  static bool IsNeeded(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  absl::Status Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                    RegionPlan& plan) override;

 private:
  /// What is known of one object, in its own coordinates.
  struct Seen {
    MultiPolygon lowest;  ///< what stands on the bed or a raft
    MultiPolygon low;     ///< all outlines as high as rafts
  };
  using SeenObjects = std::map<int32_t, Seen>;

  const ObjectPlanOptions& OptionsOf(int32_t object) const {
    return options_.objects[static_cast<size_t>(object)];
  }
  /// The objects that have a raft of their own.
  std::set<int32_t> Alone(const SeenObjects& seen) const;
  SeenObjects LookAt(std::span<const SlicedLayer> parts, const RegionPlan& plan) const;
  MultiPolygon Carried(const SeenObjects& seen, const ObjectPlanOptions& group) const;
  MultiPolygon NotCarried(const SeenObjects& seen, const ObjectPlanOptions& group) const;
  /// What `group`'s raft covers, without the room of others.
  std::vector<RaftLayer> LayersOf(const SeenObjects& seen, const ObjectPlanOptions& group,
                                  const RegionPlan& plan) const;
  void AddRaft(int32_t object, const ObjectPlanOptions& options, std::vector<RaftLayer> layers,
               RegionPlan& plan) const;
  void Lift(RegionPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
};

}  // namespace slicefarm::planning
