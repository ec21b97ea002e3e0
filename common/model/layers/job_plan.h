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

/// A copy of an object on the plate. Its toolpaths are the object's, shifted.
struct Copy {
  int32_t object = 0;
  Point shift;       ///< in whole micrometres, so that it moves rounded coordinates exactly
  int32_t pass = 0;  ///< copies of a pass are printed layer by layer, one pass after the other

  friend bool operator==(const Copy&, const Copy&) = default;
};

/// What is decided for a section of one stack, in the object's own coordinates.
struct SectionPlan {
  int32_t stack = 0;  ///< its id
  Point entry;               ///< start the section near here
  std::optional<Point> exit;  ///< end it near here, where the section above starts
  /// Where walls start, by the ring of OutlineOf; empty: near the nozzle.
  std::vector<Point> seams;
  MultiPolygon carried = {};  ///< supports lie right below its underside here
  std::optional<SpiralTurn> spiral = {};  ///< its only wall is a turn of a spiral
  MultiPolygon curled = {};  ///< what hangs over stands above the layer here: travels keep off

  friend bool operator==(const SectionPlan&, const SectionPlan&) = default;
};

/// The plan of a stack, by its id; null: nothing is decided for it. `plans`: by ascending stack.
inline const SectionPlan* FindPlan(int32_t stack, std::span<const SectionPlan> plans) {
  const auto found = std::ranges::lower_bound(plans, stack, {}, &SectionPlan::stack);
  return found != plans.end() && found->stack == stack ? &*found : nullptr;
}

/// What is decided for the sparse infill of one region of a stack's section, in the object's own
/// coordinates.
struct PlannedInfill {
  int32_t stack = 0;     ///< its id
  int32_t settings = 0;  ///< row of the job's tables of region settings
  FillPattern pattern = FillPattern::kGrid;
  std::vector<Polyline> lines;  ///< of patterns that planning lays out; they may reach beyond
  MultiPolygon left_out;        ///< no sparse infill here
  MultiPolygon combined;        ///< here it is printed as high as `combined_height_nm`
  Coord combined_height_nm = 0;

  friend bool operator==(const PlannedInfill&, const PlannedInfill&) = default;
};

/// What is decided for a layer before the fan-out, so that layers are independent afterwards.
struct LayerPlan {
  Point entry;                        ///< start the layer near here, in plate coordinates
  /// The layer below ends near `entry` with the filament ready to print, and the section of the
  /// only copy begins there; as does this one near the exit of its last section. Else the filament
  /// is retracted where layers meet.
  bool begins_ready = false;
  bool ends_ready = false;
  std::vector<SectionPlan> sections;  ///< by ascending stack
  std::vector<Path> paths;            ///< finished ones in plate coordinates, printed first
  std::vector<PlannedInfill> infill;  ///< by ascending stack, then row; none: nothing is decided
  Coord paths_height_nm = 0;          ///< how high `paths` are; 0: as the layer

  friend bool operator==(const LayerPlan&, const LayerPlan&) = default;
};

/// A stack that planning adds.
struct AddedStack {
  Stack stack;
  Coord lift_nm = 0;  ///< its bottom, above the bed
  std::vector<ObjectSection> sections;  ///< its own layers, upwards

  friend bool operator==(const AddedStack&, const AddedStack&) = default;
};

/// Finished paths in plate coordinates that the lowest layers of the print begin with.
struct Skirt {
  std::vector<Path> loops;
  int32_t layers = 0;  ///< from the lowest, but for those of supports alone (OnlySupports)

  friend bool operator==(const Skirt&, const Skirt&) = default;
};

/// How good the planned seams are. A seam's step is its distance from that of the ring below which
/// it follows.
struct SeamQuality {
  int64_t loops = 0;        ///< outlines with a planned seam
  int64_t followers = 0;    ///< of them, above another
  int64_t jumps = 0;        ///< of the followers, with a step of more than 1 mm
  double steps_mm = 0;      ///< sum of the other followers' steps
  int64_t with_corner = 0;  ///< loops that have an inner corner, or an outer one of 30 degrees
  int64_t on_corner = 0;    ///< of them, with the seam there
  int64_t overhanging = 0;  ///< seams that hang over the edge of the layer below

  friend bool operator==(const SeamQuality&, const SeamQuality&) = default;
};

/// What planning makes of the outlines of a whole job.
struct JobPlan {
  std::vector<LayerPlan> layers;   ///< one a layer of the print, without the skirt's paths
  std::vector<Coord> lifts_nm;     ///< by object: its part's bottom, above the bed; fewer: 0
  std::vector<AddedStack> stacks;  ///< by ascending id
  Skirt skirt;
  std::vector<Copy> copies;  ///< as in SlicedJob::copies
  SeamQuality seams;
  std::vector<std::string> notes;     ///< for the job's report: what was chosen, and why
  std::vector<std::string> warnings;  ///< what cannot be made as it was asked for

  friend bool operator==(const JobPlan&, const JobPlan&) = default;
};

}  // namespace slicefarm
