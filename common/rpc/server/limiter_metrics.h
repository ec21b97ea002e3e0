#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <vector>

#include "common/rpc/server/admission.h"

namespace slicefarm::rpc {

/// Metrics of the load of a service: slicefarm_calls{state="working"|"waiting"} and
/// slicefarm_call_slots.
class LimiterMetrics : public prometheus::Collectable {
 public:
  /// REQUIRES: `admission` outlives this object.
  explicit LimiterMetrics(const Admission& admission) : admission_(admission) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  const Admission& admission_;
};

}  // namespace slicefarm::rpc
