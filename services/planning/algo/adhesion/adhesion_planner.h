#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "common/model/options/adhesion_options.h"
#include "common/stage/slicing_stage.h"
#include "common/stage/stages.h"
#include "services/planning/algo/adhesion/skirt.h"
#include "services/planning/algo/planner/planner.h"

namespace slicefarm {
struct PlanningOptions;
}  // namespace slicefarm

namespace slicefarm::planning {

/// Puts brims and the skirt around all that stands on the bed, on the layers of the print: around
/// every copy, its supports and the rafts. Brims keep away from rafts and from a draft shield, the
/// skirt goes round all.
///
/// Brims: stacks of StackKind::kBrim, with regions of Role::kBrim in the first layer. An object
/// that has room around all of its copies has its own, which is printed and cancelled with each.
/// Those of others with equal settings are one region, so that lines run round copies that stand
/// close together; and so are all with complete_objects, as they lie before anything stands. None
/// under an object with a raft. Skirt: finished paths in the layers from the first one up. Without
/// a draft shield it ends with skirt_height, with one that is enabled with the last layer that has
/// outlines. Nothing lies outside of the bed.
///
/// What is kept of the layers: what is on the bed; the convex hulls of what the skirt goes round.
/// Errors: REQUEST_TOO_LARGE for a skirt of more than 20 million points on all layers; Cancelled,
/// polled for each brim.
class AdhesionPlanner : public Planner {
 public:
  /// `options` and `copies` must outlive this. Every copy's object has options.
  AdhesionPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// What is known of one object, in its own coordinates.
  struct Seen {
    MultiPolygon on_bed;  ///< of its part and supports
    MultiPolygon raft;    ///< on the bed
    Polygon hull;         ///< of what is as high as the skirt
    Coord height_nm = 0;  ///< of the object
  };

  bool HasRaft(int32_t object) const;
  bool HasBrim(int32_t object) const;
  void LookAt(const SlicedLayer& layer, const ObjectSection& section, bool in_skirt);

  /// In plate coordinates: `of` each object at the places of its copies.
  MultiPolygon OnPlate(MultiPolygon Seen::*of) const;
  /// An object's brim, with the width that it comes to.
  BrimOptions BrimOf(int32_t object, const Seen& seen) const;
  /// The objects that have a brim of their own.
  std::set<int32_t> Alone() const;
  absl::StatusOr<MultiPolygon> OwnBrim(int32_t object, const CancelToken& cancel) const;
  absl::StatusOr<std::vector<Region>> PlaceBrims(const std::set<int32_t>& alone,
                                                 const MultiPolygon& shield,
                                                 const CancelToken& cancel) const;
  /// All that the skirt goes round but for brims.
  MultiPolygon Fenced() const;

  void AddBrim(int32_t object, std::vector<Region> brims, JobPlan& plan) const;
  absl::Status AddSkirt(std::vector<Path> loops, JobPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const MultiPolygon bed_;
  const bool wanted_;
  std::map<int32_t, Seen> seen_;  ///< by object; the plate's too
  SkirtReach skirt_reach_;
  int32_t layers_ = 0;  ///< that a skirt counts, up to the last one with outlines of parts
  Coord first_height_nm_ = 0;
};

}  // namespace slicefarm::planning
