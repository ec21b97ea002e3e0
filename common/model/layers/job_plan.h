#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "common/model/options/fill_patterns.h"
#include "common/model/path.h"
#include "common/model/region.h"
#include "common/model/spiral.h"

namespace slicefarm {

/// Copy of an object on the plate. The toolpaths of a copy are the object's toolpaths, moved by
/// `shift`.
struct Copy {
  int32_t object = 0;
  /// Displacement in whole micrometres, so that rounded coordinates are shifted exactly.
  Point shift;
  /// Number of the pass; a pass prints its copies layer by layer before the next pass begins.
  int32_t pass = 0;

  friend bool operator==(const Copy&, const Copy&) = default;
};

/// Planning decisions for one stack's section in a layer, in the object's own coordinates.
struct SectionPlan {
  int32_t stack = 0;  ///< id of the stack
  Point entry;        ///< point near which the section starts
  /// point near which the section ends: the entry of the same stack in the layer above
  std::optional<Point> exit;
  /// Start points of the walls, one per ring of OutlineOf. Empty: walls start near the nozzle.
  std::vector<Point> seams;
  MultiPolygon above_supports = {};  ///< area directly above supports
  /// turn of a spiral; this turn is the section's only wall
  std::optional<SpiralTurn> spiral = {};
  /// Area where overhangs have curled up above the layer; travels avoid it.
  MultiPolygon curled = {};
  MultiPolygon air = {};  ///< area with neither the part nor a support below it, if it is needed

  friend bool operator==(const SectionPlan&, const SectionPlan&) = default;
};

/// Returns the plan of the stack with the given id, or null if planning decided nothing for this
/// stack. `plans`: sorted by stack id.
inline const SectionPlan* FindPlan(int32_t stack, std::span<const SectionPlan> plans) {
  const auto found = std::ranges::lower_bound(plans, stack, {}, &SectionPlan::stack);
  return found != plans.end() && found->stack == stack ? &*found : nullptr;
}

/// Planning decisions for the sparse infill of one region of a stack's section, in the object's own
/// coordinates.
struct PlannedInfill {
  int32_t stack = 0;     ///< id of the stack
  int32_t settings = 0;  ///< index into the job's tables of region settings
  FillPattern pattern = FillPattern::kGrid;
  /// Lines of a pattern that planning lays out over the whole job; infill cuts them off at the
  /// region's boundary.
  std::vector<Polyline> lines;
  MultiPolygon left_out;  ///< area without sparse infill
  MultiPolygon combined;  ///< area where the sparse infill is `combined_height_nm` high
  Coord combined_height_nm = 0;
  /// Middle of the connected body of each island of OutlineOf, in the order of the islands. Empty:
  /// patterns are laid out around the middle of the object.
  std::vector<Point> body_middles;

  friend bool operator==(const PlannedInfill&, const PlannedInfill&) = default;
};

/// Planning decisions for one layer. Planning makes them before the layers are distributed to
/// workers, so that the layers are independent afterwards.
struct LayerPlan {
  Point entry;  ///< point near which the layer starts, in plate coordinates
  /// True: the layer below ends near `entry` with the filament ready to print, and the section of
  /// the layer's only copy begins there. False: the filament is retracted between the two layers.
  /// `ends_ready`: true if this layer likewise ends ready, at the `exit` of its last section.
  bool begins_ready = false;
  bool ends_ready = false;
  std::vector<SectionPlan> sections;  ///< one plan per stack, sorted by stack id
  std::vector<Path> paths;            ///< finished paths in plate coordinates, printed first
  /// One entry per stack and region settings, sorted by both. Empty: no decisions.
  std::vector<PlannedInfill> infill;
  Coord paths_height_nm = 0;  ///< height of the beads of `paths`; 0: the layer's height

  friend bool operator==(const LayerPlan&, const LayerPlan&) = default;
};

/// Stack that planning adds, such as a brim, raft or support.
struct AddedStack {
  Stack stack;
  Coord lift_nm = 0;                    ///< height of the stack's bottom above the bed
  std::vector<ObjectSection> sections;  ///< layers of the stack, from the bottom

  friend bool operator==(const AddedStack&, const AddedStack&) = default;
};

/// Finished paths in plate coordinates with which the lowest layers of the print begin.
struct Skirt {
  std::vector<Path> loops;
  /// Number of layers with the skirt, counted from the lowest layer. Layers that only have supports
  /// (OnlySupports) are not counted.
  int32_t layers = 0;
  /// loops of the layers above the lowest one; empty: `loops`
  std::vector<Path> upper_loops = {};

  friend bool operator==(const Skirt&, const Skirt&) = default;
};

/// Quality of the planned seams. If a seam follows the seam of a ring in the layer below, the
/// distance between the two seams is called its step.
struct SeamQuality {
  int64_t loops = 0;      ///< number of outlines with a planned seam
  int64_t followers = 0;  ///< number of seams that follow a seam in the layer below
  int64_t jumps = 0;      ///< number of followers with a step of more than 1 mm
  double steps_mm = 0;    ///< sum of the steps of all followers that are not jumps
  /// Number of loops that have a concave corner, or a convex corner of 30 degrees.
  int64_t with_corner = 0;
  int64_t on_corner = 0;    ///< number of loops in `with_corner` with the seam at such a corner
  int64_t overhanging = 0;  ///< number of seams on overhangs, outside of the layer below

  friend bool operator==(const SeamQuality&, const SeamQuality&) = default;
};

/// Result of planning for the outlines of a whole job.
struct JobPlan {
  std::vector<LayerPlan> layers;  ///< plans of the print's layers, without the paths of the skirt
  /// Height of each object's bottom above the bed, indexed by object. The list may be shorter than
  /// the list of objects; missing entries are 0.
  std::vector<Coord> lifts_nm;
  std::vector<AddedStack> stacks;  ///< added stacks, sorted by id
  Skirt skirt;
  std::vector<Copy> copies;  ///< copies in the form of SlicedJob::copies
  SeamQuality seams;
  std::vector<std::string> notes;     ///< notes for the job's report: decisions and their reasons
  std::vector<std::string> warnings;  ///< requests that planning cannot fulfil

  friend bool operator==(const JobPlan&, const JobPlan&) = default;
};

}  // namespace slicefarm
