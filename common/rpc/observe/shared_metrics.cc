#include "common/rpc/observe/shared_metrics.h"

namespace slicefarm::rpc {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricType;

ClientMetric Gauge(int64_t value) {
  ClientMetric metric;
  metric.gauge.value = static_cast<double>(value);
  return metric;
}

ClientMetric Counter(int64_t value) {
  ClientMetric metric;
  metric.counter.value = static_cast<double>(value);
  return metric;
}

ClientMetric Takes(const char* result, int64_t value) {
  ClientMetric metric = Counter(value);
  metric.label = {{"result", result}};
  return metric;
}

}  // namespace

std::vector<prometheus::MetricFamily> SharedMetrics::Collect() const {
  const SharedCache::Counts counts = cache_.counts();
  return {{"slicefarm_shared_bytes",
           "Stored bytes of values that the calls of jobs share",
           MetricType::Gauge,
           {Gauge(counts.bytes)}},
          {"slicefarm_shared_values",
           "Stored values that the calls of jobs share",
           MetricType::Gauge,
           {Gauge(counts.entries)}},
          {"slicefarm_shared_takes_total",
           "Values that calls referred to: stored, or to be sent first",
           MetricType::Counter,
           {Takes("hit", counts.hits), Takes("miss", counts.misses)}},
          {"slicefarm_shared_evictions_total",
           "Values that were removed for newer ones",
           MetricType::Counter,
           {Counter(counts.evicted)}}};
}

}  // namespace slicefarm::rpc
