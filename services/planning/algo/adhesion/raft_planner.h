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

/// Plans rafts for the objects with a raft setting, and lifts these objects and their supports.
///
/// An object with free space around all of its copies has its own raft, which is printed and
/// cancelled with each copy. Copies that are closer and have equal options share one raft: the
/// union of their rafts. With complete_objects all rafts are shared, because they are printed
/// before any object. A raft keeps 0.5 mm away from objects that it does not support, and from
/// rafts with different options. Where two rafts would meet, the raft of the earlier object gets
/// the area. A raft extends below supports as well as parts. No raft leaves the bed.
///
/// Output: stacks of StackKind::kRaft, with regions of Role::kRaft and kRaftInterface. Errors:
/// Cancelled, polled for each raft.
class RaftPlanner : public RegionPlanner {
 public:
  /// `options` and `copies` must outlive this planner. `options` has an entry for the object of
  /// every copy.
  RaftPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies)
      : options_(options), copies_(copies) {}

  /// Returns true if some object has a raft.
  static bool IsNeeded(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  absl::Status Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                    RegionPlan& plan) override;

 private:
  /// Outlines of one object, in the object's own coordinates.
  struct Seen {
    /// outlines of the lowest layer: on the bed, or on the raft if there is one
    MultiPolygon lowest;
    MultiPolygon low;  ///< union of all outlines below the top of the highest raft on the plate
  };
  using SeenObjects = std::map<int32_t, Seen>;

  const ObjectPlanOptions& OptionsOf(int32_t object) const {
    return options_.objects[static_cast<size_t>(object)];
  }
  /// Returns the objects that get a raft of their own.
  std::set<int32_t> Alone(const SeenObjects& seen) const;
  SeenObjects LookAt(std::span<const SlicedLayer> parts, const RegionPlan& plan) const;
  MultiPolygon AboveRaft(const SeenObjects& seen, const ObjectPlanOptions& group) const;
  MultiPolygon BesideRaft(const SeenObjects& seen, const ObjectPlanOptions& group) const;
  /// Returns the raft layers for all objects with the options `group`, without the areas of other
  /// objects and rafts.
  std::vector<RaftLayer> LayersOf(const SeenObjects& seen, const ObjectPlanOptions& group,
                                  const RegionPlan& plan) const;
  void AddRaft(int32_t object, const ObjectPlanOptions& options, std::vector<RaftLayer> layers,
               RegionPlan& plan) const;
  void Lift(RegionPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
};

}  // namespace slicefarm::planning
