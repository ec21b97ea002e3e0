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

/// Refuses jobs in which two things would be printed in the same place: parts and supports of
/// different copies, rafts, brims, the skirt. What one copy has of its own, such as a part and its
/// supports, is not looked at.
///
/// Runs after the planner of brims and skirts. Adds nothing to the plan. Errors of Finish:
/// PATHS_CONFLICT for the lowest place that was found, with the names of both.
/// Cost: the boxes of sections, and a boolean operation a layer for copies whose sections' boxes
/// meet there; one for each layer of a raft, a brim, the skirt, of all that is beside it.
class ConflictPlanner : public Planner {
 public:
  /// All must outlive this. `object_names`: by object; may be fewer.
  ConflictPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                  std::span<const std::string> object_names);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// A section, in its object's coordinates.
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
  using Slices = std::map<int32_t, std::deque<Slice>>;  ///< by object

  /// A copy's slice, at its place on the plate.
  struct Placed {
    Stack stack;
    size_t copy = 0;
    MultiPolygon outline;
  };

  static Slice SliceOf(const ObjectSection& section, Coord top_nm);
  void AddToHull(int32_t object, const MultiPolygon& outline);
  void CompareAndKeep(const Slice& slice);
  /// With what stands beside any of its object's copies.
  void Compare(const Slice& slice, const Slices& kept);
  void CompareBrims(const JobPlan& plan);
  void CompareSkirt(const Skirt& skirt);
  /// What lies beside a slice of the plate's.
  std::vector<Placed> LowBeside(const Slice& slice) const;
  void ComparePlaced(const Slice& slice, const std::vector<Placed>& others);
  std::string NameOfStack(const Stack& stack, size_t copy) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const std::span<const std::string> object_names_;
  Coord low_nm_ = 1;  ///< what begins below may meet what the plate has of its own
  NearCopies near_;
  Slices kept_;  ///< of copies near others: what the next sections may meet
  Slices low_;   ///< what begins below low_nm_, the plate's too
  SkirtReach skirt_reach_;
  std::map<int32_t, Polygon> hulls_;  ///< by object, on layers that the skirt reaches
  absl::Status found_;
};

}  // namespace slicefarm::planning
