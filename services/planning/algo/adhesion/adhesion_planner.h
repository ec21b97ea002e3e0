#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "common/model/options/adhesion_options.h"
#include "common/model/options/planning_options.h"
#include "common/stage/stages.h"
#include "services/planning/algo/adhesion/raft.h"
#include "services/planning/algo/planner.h"

namespace slicefarm::planning {

/// Puts rafts, brims and the skirt on the plate, around every copy, in this order: brims keep away
/// from rafts and from a draft shield, the skirt goes round all.
///
/// Rafts: copies with equal options share one; what carries them is united. A raft keeps 0.5 mm
/// away from objects that it does not carry, and from rafts of other options, of which the one of
/// the earlier object has the place. Regions of Role::kRaft and kRaftInterface, in the layers whose
/// tops are the raft's. Brims: regions of Role::kBrim in the first layer; those of equal settings
/// are one region, so that lines run round copies that stand close together. None under an object
/// with a raft. Skirt: finished paths in the layers from the first one up. Without a draft shield
/// it ends with skirt_height, with one that is enabled with the last layer that has outlines.
/// Nothing lies outside of the bed.
///
/// What is kept of the layers: each object's first outlines; of objects beside a raft what covers
/// its height, united; the convex hulls of what the skirt goes round.
/// Errors: REQUEST_MALFORMED if no layer ends at the top of a raft's layer; REQUEST_TOO_LARGE for a
/// skirt of more than 20 million points on all layers; Cancelled, polled for each raft and brim.
class AdhesionPlanner : public Planner {
 public:
  /// `options` and `copies` must outlive this. Every copy's object has options.
  AdhesionPlanner(const PlanningOptions& options, std::span<const PlacedCopy> copies);

  void Look(const SlicedLayer& layer, LayerPlan& plan) override;
  absl::Status Finish(const CancelToken& cancel, OpenLayers& layers, JobPlan& plan) override;

 private:
  /// What is known of one object, in its own coordinates.
  struct Seen {
    MultiPolygon first;     ///< its lowest outlines
    bool on_bed = false;    ///< they are in the first layer
    MultiPolygon low;       ///< all outlines as high as rafts
    Polygon hull;           ///< of what is as high as the skirt
    Coord height_nm = 0;    ///< of the object
  };
  /// A layer of a raft on the plate.
  struct PlacedLayer {
    RaftLayer layer;
    int32_t settings = 0;
  };

  bool HasRaft(int32_t object) const;
  bool HasBrim(int32_t object) const;
  Coord HighestRaft() const;
  void LookAt(const SlicedLayer& layer, const ObjectSection& section);

  absl::StatusOr<std::vector<PlacedLayer>> PlaceRafts(const CancelToken& cancel) const;
  MultiPolygon Carried(const ObjectPlanOptions& group) const;
  MultiPolygon NotCarried(const ObjectPlanOptions& group) const;
  absl::StatusOr<std::vector<Region>> PlaceBrims(std::span<const PlacedLayer> rafts,
                                                 const MultiPolygon& shield,
                                                 const CancelToken& cancel) const;
  /// All that the skirt goes round but for brims.
  MultiPolygon Fenced(std::span<const PlacedLayer> rafts) const;

  void AddRafts(std::vector<PlacedLayer> rafts, JobPlan& plan) const;
  absl::Status AddSkirt(std::vector<Path> loops, JobPlan& plan) const;

  const PlanningOptions& options_;
  const std::span<const PlacedCopy> copies_;
  const Polygon bed_;
  const Coord highest_raft_nm_;
  const bool wanted_;
  std::map<int32_t, Seen> seen_;          ///< by object
  std::map<Coord, int32_t> layer_at_;     ///< by its top, as high as rafts
  int32_t layers_ = 0;                    ///< up to the last one with outlines
  Coord first_height_nm_ = 0;
};

}  // namespace slicefarm::planning
