#pragma once

#include <vector>

#include "common/model/layers/job_plan.h"
#include "common/model/options/ordering_options.h"

namespace slicefarm {

/// Data of a job that all calls of the ordering stage share.
struct OrderingJob {
  OrderingOptions options;
  std::vector<Copy> copies;

  friend bool operator==(const OrderingJob&, const OrderingJob&) = default;
};

}  // namespace slicefarm
