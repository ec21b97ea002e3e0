#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/support_options.h"

namespace slicefarm {

/// Where loops start.
enum class SeamPosition : uint8_t {
  kNearest,  ///< near the nozzle
  kRear,     ///< at the back, in line
  kAligned,  ///< in line up the object, at corners
  kRandom,   ///< anywhere, each loop elsewhere
  kHidden,   ///< in line, where the least is seen of it
};

/// spiral_vase: hollow layers are printed as one bead that winds up.
struct SpiralOptions {
  Coord width_nm = 0;  ///< of the bead; 0: no spiral
  bool blends = true;  ///< turns lead over into each other: not where their skin is fuzzy

  friend bool operator==(const SpiralOptions&, const SpiralOptions&) = default;
};

/// What planning is told of one object.
struct ObjectPlanOptions {
  SeamPosition seam = SeamPosition::kAligned;  ///< seam_position
  BrimOptions brim = {};                       ///< none under an object with a raft
  int32_t brim_settings = 0;                   ///< row of the job's tables of region settings
  RaftOptions raft = {};
  std::vector<int32_t> raft_settings = {};  ///< rows, one for each layer of the raft
  SupportOptions support = {};
  SupportRows support_settings = {};
  SpiralOptions spiral = {};

  friend bool operator==(const ObjectPlanOptions&, const ObjectPlanOptions&) = default;
};

/// How copies are printed one after the other, each as a whole.
struct SequencePlanOptions {
  bool complete_objects = false;              ///< complete_objects
  Coord clearance_radius_nm = 20 * kNmPerMm;  ///< extruder_clearance_radius: around the nozzle
  Coord clearance_height_nm = 20 * kNmPerMm;  ///< extruder_clearance_height: gantry over nozzle

  friend bool operator==(const SequencePlanOptions&, const SequencePlanOptions&) = default;
};

/// Settings of a job that planning needs.
struct JobPlanOptions {
  SequencePlanOptions sequence;
  SkirtOptions skirt;
  int32_t skirt_settings = 0;        ///< row of the job's regions
  bool objects_may_overlap = false;  ///< objects_may_overlap
  bool avoid_curled = false;  ///< avoid_crossing_curled_overhangs: tells where parts curl up
  /// bed_shape without bed_exclude_area: nothing is added outside of it; empty: no limit.
  MultiPolygon bed;

  friend bool operator==(const JobPlanOptions&, const JobPlanOptions&) = default;
};

/// Options of the planning stage.
struct PlanningOptions : JobPlanOptions {
  std::vector<ObjectPlanOptions> objects = {{}};  ///< by object
  std::vector<InfillOptions> infill;              ///< by region; empty: none needs a plan

  using Row = JobPlanOptions;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.objects, self.infill);
  }
  friend bool operator==(const PlanningOptions&, const PlanningOptions&) = default;
};

}  // namespace slicefarm
