#pragma once

#include <cstdint>
#include <tuple>
#include <vector>

#include "common/geometry/polygon.h"
#include "common/model/options/adhesion_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/seam_position.h"
#include "common/model/options/sequence_options.h"
#include "common/model/options/spiral_options.h"
#include "common/model/options/support_options.h"

namespace slicefarm {

/// Object settings for planning.
struct ObjectPlanOptions {
  SeamPosition seam = SeamPosition::kAligned;  ///< setting seam_position
  BrimOptions brim = {};      ///< brim of the object; kNone for an object with a raft
  int32_t brim_settings = 0;  ///< index into the job's tables of region settings
  RaftOptions raft = {};
  /// index of region settings for each layer of the raft, indexed by layer
  std::vector<int32_t> raft_settings = {};
  SupportOptions support = {};
  SupportRows support_settings = {};
  SpiralOptions spiral = {};

  friend bool operator==(const ObjectPlanOptions&, const ObjectPlanOptions&) = default;
};

/// Job settings for planning.
struct JobPlanOptions {
  SequencePlanOptions sequence;
  SkirtOptions skirt;
  bool combine_brims = true;         ///< `combine_brims`: brims that touch become one brim
  int32_t skirt_settings = 0;        ///< index into the job's tables of region settings
  bool objects_may_overlap = false;  ///< setting objects_may_overlap
  /// `avoid_crossing_curled_overhangs`: planning computes SectionPlan::curled
  bool avoid_curled = false;
  /// unsupported_wall_last of any region: planning computes SectionPlan::air
  bool find_air = false;
  bool slow_curled = false;  ///< MachineMotion::slow_curled, which needs the same areas
  /// bed_shape without bed_exclude_area: area outside of which planning adds nothing. Empty: no
  /// limit.
  MultiPolygon bed;

  friend bool operator==(const JobPlanOptions&, const JobPlanOptions&) = default;
};

/// Options of the planning stage.
struct PlanningOptions : JobPlanOptions {
  std::vector<ObjectPlanOptions> objects = {{}};  ///< options of each object
  /// infill options of each region; empty: no region needs a plan (NeedsPlan)
  std::vector<InfillOptions> infill;

  using Row = JobPlanOptions;
  template <typename Self>
  static auto TablesOf(Self& self) {
    return std::tie(self.objects, self.infill);
  }
  friend bool operator==(const PlanningOptions&, const PlanningOptions&) = default;
};

}  // namespace slicefarm
