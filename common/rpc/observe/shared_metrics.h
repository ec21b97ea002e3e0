#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <vector>

#include "common/base/shared/shared_cache.h"

namespace slicefarm::rpc {

/// Metrics of the shared values in a server's SharedCache: slicefarm_shared_bytes,
/// slicefarm_shared_values, slicefarm_shared_takes_total{result="hit"|"miss"} and
/// slicefarm_shared_evictions_total.
class SharedMetrics : public prometheus::Collectable {
 public:
  /// REQUIRES: `cache` outlives this object.
  explicit SharedMetrics(const SharedCache& cache) : cache_(cache) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  const SharedCache& cache_;
};

}  // namespace slicefarm::rpc
