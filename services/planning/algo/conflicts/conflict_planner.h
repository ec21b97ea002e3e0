#pragma once

#include <deque>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/adhesion/skirt.h"
#include "services/planning/algo/conflicts/near_copies.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Refuses jobs in which two structures would be printed in the same location. Structures are parts
/// and supports of different copies, rafts, brims and the skirt. Overlaps within one copy are not
/// checked, for example between a part and its supports.
///
/// Runs after the planner of brims and skirts. Adds nothing to the plan. Errors of Finish:
/// PATHS_CONFLICT for the lowest overlap, with the names of both structures. Cost: a comparison of
/// the sections' boxes, and one boolean operation per layer for copies with intersecting boxes.
/// Each layer of a raft, a brim or the skirt needs one boolean operation with everything beside it.
class ConflictPlanner : public Planner {
 public:
  /// All arguments must outlive this planner. `object_names`: names for messages, indexed by
  /// object; may have fewer entries than objects.
  ConflictPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                  std::span<const std::string> object_names);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// One section of a stack (common/model/stack.h), in its object's coordinates. Heights are above
  /// the bed.
  struct Slice {
    Stack stack;
    Coord bottom_nm = 0;
    Coord top_nm = 0;
    Box box;
    MultiPolygon outline;

    bool SharesHeight(const Slice& other) const {
      return bottom_nm < other.top_nm && other.bottom_nm < top_nm;
    }
  };
  using Slices = std::map<int32_t, std::deque<Slice>>;  ///< slices per object

  /// Slice of one copy, at the copy's position on the plate.
  struct Placed {
    Stack stack;
    size_t copy = 0;
    MultiPolygon outline;
  };

  static Slice SliceOf(const ObjectSection& section, Coord top_nm);
  void AddToHull(int32_t object, const MultiPolygon& outline);
  void CompareAndKeep(const Slice& slice);
  /// Compares a slice with the slices in `kept`, for all pairs of copies that may overlap
  /// (NearCopies).
  void Compare(const Slice& slice, const Slices& kept);
  void CompareBrims(const JobPlan& plan);
  void CompareSkirt(const Skirt& skirt);
  /// Returns the slices in `low_` that meet the box of `slice`, which is a slice of the plate.
  std::vector<Placed> LowBeside(const Slice& slice) const;
  void ComparePlaced(const Slice& slice, const std::vector<Placed>& others);
  std::string NameOfStack(const Stack& stack, size_t copy) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const std::span<const std::string> object_names_;
  /// Height below which objects may meet rafts, brims and skirt of the plate.
  Coord low_nm_ = 1;
  NearCopies near_;
  Slices kept_;  ///< slices of copies with close neighbours, for comparison with later sections
  Slices low_;   ///< slices that begin below low_nm_; the plate's slices too
  SkirtReach skirt_reach_;
  /// per object: hull of its outlines in the layers that the skirt reaches
  std::map<int32_t, Polygon> hulls_;
  absl::Status found_;
};

}  // namespace slicefarm::planning
