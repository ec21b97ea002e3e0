#pragma once

#include <vector>

#include "prometheus/collectable.h"
#include "prometheus/metric_family.h"

namespace slicefarm::rpc {

/// What this process uses of the machine, read from /proc when asked; by the names of Prometheus'
/// own client libraries.
class ProcessMetrics : public prometheus::Collectable {
 public:
  std::vector<prometheus::MetricFamily> Collect() const override;
};

}  // namespace slicefarm::rpc
