#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <vector>

#include "services/coordinator/algo/dispatcher.h"
#include "services/coordinator/store/job_store.h"

namespace slicefarm::coordinator {

/// What the coordinator shows beside its calls: slicefarm_jobs{state},
/// slicefarm_ranges_total{outcome}, slicefarm_worker_slots. Looked up when Prometheus asks; both
/// must outlive it.
class CoordinatorMetrics : public prometheus::Collectable {
 public:
  CoordinatorMetrics(JobStore& jobs, const Dispatcher& dispatcher)
      : jobs_(jobs), dispatcher_(dispatcher) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  JobStore& jobs_;
  const Dispatcher& dispatcher_;
};

}  // namespace slicefarm::coordinator
