#pragma once

#include <vector>

#include "common/model/job_facts.h"
#include "common/model/layers/job_plan.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm {

/// Data of a job that all its tasks share.
struct FdmShared {
  FdmSettings settings;
  std::vector<Copy> copies;
  JobFacts facts;

  friend bool operator==(const FdmShared&, const FdmShared&) = default;
};

}  // namespace slicefarm
