#pragma once

#include "common/model/job_facts.h"
#include "common/model/options/motion_options.h"

namespace slicefarm {

/// Data of a job that all calls of the motion stage share.
struct MotionJob {
  MotionOptions options;
  JobFacts facts;

  friend bool operator==(const MotionJob&, const MotionJob&) = default;
};

}  // namespace slicefarm
