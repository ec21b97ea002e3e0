#pragma once

#include <vector>

#include "prometheus/collectable.h"
#include "prometheus/metric_family.h"

namespace slicefarm::rpc {

/// Resource usage of this program, read from /proc on each request. Metrics have the
/// same names as in Prometheus' client libraries.
class ProcessMetrics : public prometheus::Collectable {
 public:
  std::vector<prometheus::MetricFamily> Collect() const override;
};

}  // namespace slicefarm::rpc
