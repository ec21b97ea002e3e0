#include "services/coordinator/server/coordinator_metrics.h"

#include <string>
#include <utility>

namespace slicefarm::coordinator {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

MetricFamily Jobs(JobStore& jobs) {
  MetricFamily family{"slicefarm_jobs", "Jobs in the store", MetricType::Gauge, {}};
  const auto counts = jobs.CountByState();
  if (!counts.ok()) return family;
  using enum JobState;
  for (const JobState state : {kQueued, kRunning, kSucceeded, kFailed, kCancelled}) {
    ClientMetric metric;
    metric.label = {{"state", std::string(JobStateName(state))}};
    const auto count = counts->find(state);
    metric.gauge.value = count == counts->end() ? 0 : static_cast<double>(count->second);
    family.metric.push_back(std::move(metric));
  }
  return family;
}

MetricFamily Ranges(const DispatchCounts& counts) {
  MetricFamily family{
      "slicefarm_ranges_total", "Layer ranges by what became of them", MetricType::Counter, {}};
  for (const auto& [outcome, count] : {std::pair{"ok", counts.done},
                                       {"requeued", counts.requeued},
                                       {"hedged", counts.hedged},
                                       {"poisoned", counts.poisoned}}) {
    ClientMetric metric;
    metric.label = {{"outcome", outcome}};
    metric.counter.value = static_cast<double>(count);
    family.metric.push_back(std::move(metric));
  }
  return family;
}

MetricFamily Slots(int slots) {
  ClientMetric metric;
  metric.gauge.value = slots;
  return {"slicefarm_worker_slots",
          "Ranges that the workers there are can take at once",
          MetricType::Gauge,
          {metric}};
}

}  // namespace

std::vector<MetricFamily> CoordinatorMetrics::Collect() const {
  return {Jobs(jobs_), Ranges(dispatcher_.Counts()), Slots(dispatcher_.Slots())};
}

}  // namespace slicefarm::coordinator
