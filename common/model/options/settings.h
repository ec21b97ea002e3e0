#pragma once

#include "common/model/options/slicing_options.h"
#include "common/model/process.h"
#include "common/model/process_value.h"

namespace slicefarm {

/// Settings of a plate, complete and validated: tables with a row for each object, region and tool.
struct JobSettings {
  SlicingOptions slicing;
  ProcessValue own;  ///< settings that its process alone has: FdmSettings, ExposureSettings, ...

  Process process() const { return own.process(); }

  friend bool operator==(const JobSettings&, const JobSettings&) = default;
};

/// One resolved set of settings: a row of each scope.
struct JobRows {
  JobSlicingOptions slicing;
  ObjectSlicingOptions object;
  ProcessValue own;  ///< rows that its process alone has: FdmRows, ExposureRows, ...

  Process process() const { return own.process(); }

  friend bool operator==(const JobRows&, const JobRows&) = default;
};

}  // namespace slicefarm
