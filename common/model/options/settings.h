#pragma once

#include "common/model/options/slicing_options.h"
#include "common/model/process.h"
#include "common/model/process_value.h"

namespace slicefarm {

/// Complete and validated settings of a plate: tables with one row per object, region and tool.
struct JobSettings {
  SlicingOptions slicing;
  ProcessValue own;  ///< settings of the job's process: FdmSettings, ExposureSettings, ...

  Process process() const { return own.process(); }

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// Resolved settings of one region: one row of each table in JobSettings.
struct JobRows {
  JobSlicingOptions slicing;
  ObjectSlicingOptions object;
  ProcessValue own;  ///< rows of the job's process: FdmRows, ExposureRows, ...

  Process process() const { return own.process(); }

  friend bool operator==(const JobRows&, const JobRows&) = default;
};

}  // namespace slicefarm
