#include "common/rpc/server/limiter_metrics.h"

namespace slicefarm::rpc {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricType;

ClientMetric Calls(const char* state, int count) {
  ClientMetric metric;
  metric.label = {{"state", state}};
  metric.gauge.value = count;
  return metric;
}

}  // namespace

std::vector<prometheus::MetricFamily> LimiterMetrics::Collect() const {
  ClientMetric slots;
  slots.gauge.value = admission_.slots();
  return {{"slicefarm_calls",
           "Heavy calls that are processed or wait",
           MetricType::Gauge,
           {Calls("working", admission_.working()), Calls("waiting", admission_.waiting())}},
          {"slicefarm_call_slots",
           "Largest number of heavy calls processed at the same time",
           MetricType::Gauge,
           {slots}}};
}

}  // namespace slicefarm::rpc
