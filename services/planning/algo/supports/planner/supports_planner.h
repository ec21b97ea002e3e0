#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/planner/region_planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Plans supports as a stack of StackKind::kSupport for each object that requests supports
/// (supports/generator/support_planner.h).
///
/// The supports are in the object's own coordinates. All copies share them, and they are printed
/// and cancelled with each copy. So the neighbours of any copy limit the supports of all copies.
/// Supports of earlier objects are neighbours too. No support is more than kClearanceNm away from
/// the object's bounding box, or beyond half the distance to the object's next copy.
///
/// Output: regions of Role::kSupport and kSupportInterface. RegionPlan::warnings lists the
/// overhangs that no support can reach and the islands that start in the air, with position and
/// area. Errors: Cancelled.
class SupportsPlanner : public RegionPlanner {
 public:
  /// All arguments must outlive this planner. `object_names`: names for messages, indexed by
  /// object; may have fewer entries than objects. REQUIRES: `options` has an entry for the object
  /// of every copy.
  SupportsPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                  std::span<const std::string> object_names, int threads)
      : options_(options), copies_(copies), object_names_(object_names), threads_(threads) {}

  static constexpr Coord kClearanceNm = 15 * kNmPerMm;

  /// Returns true if an object on the plate requests supports.
  static bool IsNeeded(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  absl::Status Plan(std::span<const SlicedLayer> parts, const CancelToken& cancel,
                    RegionPlan& plan) override;

 private:
  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const std::span<const std::string> object_names_;
  const int threads_;
};

}  // namespace slicefarm::planning
