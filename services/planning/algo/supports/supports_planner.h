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

/// Gives objects that ask for it a stack of StackKind::kSupport (support/support_planner.h), in the
/// object's own coordinates: all copies share it, and it is printed and cancelled with each. So
/// what stands around any copy, supports of objects before it included, is around all of them;
/// beyond kRoomNm of the object, or half way to its next copy, there is no support.
///
/// Regions of Role::kSupport and kSupportInterface. What no support can carry, and what starts in
/// the air, is told in RegionPlan::warnings with its place and area.
/// Errors: Cancelled.
class SupportsPlanner : public RegionPlanner {
 public:
  /// All must outlive this. Every copy's object has options. `object_names`: by object; may be
  /// fewer.
  SupportsPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies,
                  std::span<const std::string> object_names, int threads)
      : options_(options), copies_(copies), object_names_(object_names), threads_(threads) {}

  static constexpr Coord kRoomNm = 15 * kNmPerMm;

  /// Whether some object asks for supports.
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
