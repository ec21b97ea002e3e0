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

/// Plans brims and the skirt around everything on the bed: the parts of all copies, their supports
/// and rafts. Brims keep away from rafts and from a draft shield. The skirt surrounds parts,
/// supports, rafts and brims.
///
/// Brims are stacks of StackKind::kBrim, with regions of Role::kBrim in the first layer.
/// - An object with free space around all of its copies has its own brim, which is printed and
///   cancelled with each copy.
/// - The brims of the remaining objects with equal settings form one region of the plate, so that
///   lines surround copies that are close together.
/// - With complete_objects or a draft shield, all brims belong to the plate. With complete_objects
///   they are printed before any object.
/// - An object with a raft has no brim.
///
/// Without combine_brims, each copy's brim of the plate is a region of its own.
///
/// The skirt is a set of finished paths in the layers from the first one up. Without a draft shield
/// it ends at skirt_height. An enabled draft shield ends at the last layer that has outlines. No
/// brim or skirt leaves the bed.
///
/// Memory: the outlines on the bed, and the convex hulls of the objects inside the skirt. Errors:
/// REQUEST_TOO_LARGE for a skirt of more than 20 million points on all layers; Cancelled, polled
/// for each brim.
class AdhesionPlanner : public Planner {
 public:
  /// `options` and `copies` must outlive this planner. `options` has an entry for the object of
  /// every copy.
  AdhesionPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// Outlines of one object in the layers so far, in the object's own coordinates.
  struct Seen {
    MultiPolygon on_bed;  ///< outlines of the object's part and supports on the bed
    MultiPolygon raft;    ///< outlines of the object's raft on the bed
    Polygon hull;  ///< convex hull of the object's outlines in the layers that the skirt reaches
    Coord height_nm = 0;  ///< height of the object's part, as far as its layers have been seen
  };

  bool HasRaft(int32_t object) const;
  bool HasBrim(int32_t object) const;
  void LookAt(const SlicedLayer& layer, const ObjectSection& section, bool in_skirt);

  /// Returns the area in the member `of` (on_bed or raft) of all copies and of structures that
  /// belong to the plate, in plate coordinates.
  MultiPolygon OnPlate(MultiPolygon Seen::*of) const;
  /// Returns the brim options of an object. An automatic brim gets its computed width.
  BrimOptions BrimOf(int32_t object, const Seen& seen) const;
  /// Returns the objects that get a brim of their own.
  std::set<int32_t> Alone() const;
  absl::StatusOr<MultiPolygon> OwnBrim(int32_t object, const CancelToken& cancel) const;
  absl::StatusOr<std::vector<Region>> PlaceBrims(const std::set<int32_t>& alone,
                                                 const MultiPolygon& shield,
                                                 const CancelToken& cancel) const;
  /// Returns the hulls that the skirt must surround, without brims: of each copy, and of structures
  /// that belong to the plate, such as shared rafts.
  MultiPolygon Fenced() const;

  void AddBrim(int32_t object, std::vector<Region> brims, JobPlan& plan) const;
  absl::Status AddSkirts(std::vector<std::vector<Path>> skirts, JobPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const MultiPolygon bed_;
  const bool wanted_;
  std::map<int32_t, Seen> seen_;  ///< data per object; the plate has an entry too
  SkirtReach skirt_reach_;
  /// Number of layers that a skirt can reach: all up to the last one with outlines of parts.
  int32_t layers_ = 0;
  Coord first_height_nm_ = 0;
};

}  // namespace slicefarm::planning
