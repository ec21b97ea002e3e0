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

/// Settings that hold for the whole job: the machine, and how all objects are printed.
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
  RegionSpeeds motion;

  friend bool operator==(const RegionRow&, const RegionRow&) = default;
};

/// One resolved set of settings for filament printing: a row of each scope.
struct FdmRows {
  static constexpr Process kProcess = Process::kFdm;

  MachineRow machine;
  ObjectRow object;
  RegionRow region;
  ToolRow tool;

  friend bool operator==(const FdmRows&, const FdmRows&) = default;
};

/// Settings of a plate for filament printing. Region and Path name rows of `regions`.
struct FdmSettings {
  static constexpr Process kProcess = Process::kFdm;

  MachineRow machine;
  std::vector<ObjectRow> objects = {{}};
  std::vector<RegionRow> regions = {{}};
  std::vector<ToolRow> tools = {{}};

  friend bool operator==(const FdmSettings&, const FdmSettings&) = default;
};

// Settings of a job for filament printing. REQUIRES: the job is of that process.
inline const FdmSettings& FdmOf(const JobSettings& settings) { return settings.own.As<FdmSettings>(); }
inline FdmSettings& FdmOf(JobSettings& settings) { return settings.own.As<FdmSettings>(); }
inline const FdmRows& FdmOf(const JobRows& rows) { return rows.own.As<FdmRows>(); }
inline FdmRows& FdmOf(JobRows& rows) { return rows.own.As<FdmRows>(); }

// Options of each stage: the rows that it works with.
std::vector<BeadingOptions> BeadingOf(const FdmSettings& settings);
std::vector<InfillOptions> InfillOf(const FdmSettings& settings);
/// The infill of the regions is left out where planning has nothing to decide about it.
PlanningOptions PlanningOf(const FdmSettings& settings);
OrderingOptions OrderingOf(const FdmSettings& settings);
MotionOptions MotionOf(const FdmSettings& settings);

/// Returns the options of the motion stage for a plate of one region.
MotionOptions MotionOf(const FdmRows& rows);

/// Returns how many of an object's own layers on each side a layer's result depends on.
int32_t HaloLayers(const FdmSettings& settings);

/// Returns how many of these layers the walls depend on.
int32_t BeadingHaloLayers(const FdmSettings& settings);

}  // namespace slicefarm
