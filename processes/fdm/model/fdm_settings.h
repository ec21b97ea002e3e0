#pragma once

#include <cstdint>
#include <vector>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/model/options/motion_options.h"
#include "common/model/options/ordering_options.h"
#include "common/model/options/planning_options.h"
#include "common/model/options/settings.h"
#include "common/model/process.h"

namespace slicefarm {

/// Settings of the whole job: the machine, and options common to all objects.
struct MachineRow {
  JobPlanOptions plan;
  JobOrder order;
  MachineMotion motion;

  friend bool operator==(const MachineRow&, const MachineRow&) = default;
};

/// Settings of one object, besides ObjectSlicingOptions.
using ObjectRow = ObjectPlanOptions;

/// Settings of one region of an object.
struct RegionRow {
  BeadingOptions walls;
  InfillOptions infill;
  WallOrder order;
  RegionMotion motion;

  friend bool operator==(const RegionRow&, const RegionRow&) = default;
};

/// Resolved settings for filament printing of one region: one row of each table.
struct FdmRows {
  static constexpr Process kProcess = Process::kFdm;

  MachineRow machine;
  ObjectRow object;
  RegionRow region;
  ToolRow tool;

  friend bool operator==(const FdmRows&, const FdmRows&) = default;
};

/// Filament printing settings of a plate. The member `settings` of a Region or Path is an index
/// into `regions`.
struct FdmSettings {
  static constexpr Process kProcess = Process::kFdm;

  MachineRow machine;
  std::vector<ObjectRow> objects = {{}};
  std::vector<RegionRow> regions = {{}};
  std::vector<ToolRow> tools = {{}};

  friend bool operator==(const FdmSettings&, const FdmSettings&) = default;
};

// Returns the filament printing settings of a job. REQUIRES: the job is a filament printing job.
inline const FdmSettings& FdmOf(const JobSettings& settings) {
  return settings.own.As<FdmSettings>();
}
inline FdmSettings& FdmOf(JobSettings& settings) { return settings.own.As<FdmSettings>(); }
inline const FdmRows& FdmOf(const JobRows& rows) { return rows.own.As<FdmRows>(); }
inline FdmRows& FdmOf(JobRows& rows) { return rows.own.As<FdmRows>(); }

// Returns the options of one stage, taken from the rows that the stage needs.
std::vector<BeadingOptions> BeadingOf(const FdmSettings& settings);
std::vector<InfillOptions> InfillOf(const FdmSettings& settings);
/// Returns the options of planning. They include the infill of the regions only if planning decides
/// about infill.
PlanningOptions PlanningOf(const FdmSettings& settings);
OrderingOptions OrderingOf(const FdmSettings& settings);
MotionOptions MotionOf(const FdmSettings& settings);

/// Returns the options of the motion stage for a plate of one region.
MotionOptions MotionOf(const FdmRows& rows);

/// Returns the number of an object's own layers above and below a layer on which the result of this
/// layer depends.
int32_t HaloLayers(const FdmSettings& settings);

/// Returns the number of an object's own layers above and below a layer on which the walls of this
/// layer depend.
int32_t BeadingHaloLayers(const FdmSettings& settings);

}  // namespace slicefarm
