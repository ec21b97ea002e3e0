#include "services/coordinator/server/observe/coordinator_metrics.h"

#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

namespace slicefarm::coordinator {
namespace {

using prometheus::ClientMetric;
using prometheus::MetricFamily;
using prometheus::MetricType;

/// Returns one value of a family, with at most one label.
ClientMetric Value(MetricType type, double value, const std::string& label = "",
                   const std::string& label_value = "") {
  ClientMetric metric;
  if (!label.empty()) metric.label = {{label, label_value}};
  (type == MetricType::Counter ? metric.counter.value : metric.gauge.value) = value;
  return metric;
}

MetricFamily Gauge(const std::string& name, const std::string& help, double value) {
  return {name, help, MetricType::Gauge, {Value(MetricType::Gauge, value)}};
}

MetricFamily Jobs(const std::map<JobState, int64_t>& counts) {
  MetricFamily family{"slicefarm_jobs", "Jobs in the store", MetricType::Gauge, {}};
  using enum JobState;
  for (const JobState state : {kQueued, kRunning, kSucceeded, kFailed, kCancelled}) {
    const auto count = counts.find(state);
    family.metric.push_back(Value(MetricType::Gauge,
                                  count == counts.end() ? 0 : static_cast<double>(count->second),
                                  "state", std::string(JobStateName(state))));
  }
  return family;
}

/// Adds the number of waiting jobs and the age of the oldest one, by priority.
void AddQueue(const std::vector<OpenJobs>& open, std::vector<MetricFamily>& families) {
  MetricFamily depth{"slicefarm_queue_depth", "Jobs that wait", MetricType::Gauge, {}};
  MetricFamily age{"slicefarm_queue_age_seconds",
                   "Age of the oldest waiting job; 0: no job waits",
                   MetricType::Gauge,
                   {}};
  for (const Priority priority : {Priority::kBulk, Priority::kNormal, Priority::kInteractive}) {
    const auto waiting = std::ranges::find_if(open, [&](const OpenJobs& jobs) {
      return jobs.state == JobState::kQueued && jobs.priority == priority;
    });
    const bool any = waiting != open.end();
    const std::string name = PriorityName(priority);
    depth.metric.push_back(
        Value(MetricType::Gauge, any ? static_cast<double>(waiting->count) : 0, "priority", name));
    age.metric.push_back(
        Value(MetricType::Gauge, any ? SecondsSince(waiting->oldest_us) : 0, "priority", name));
  }
  families.push_back(std::move(depth));
  families.push_back(std::move(age));
}

MetricFamily Ranges(const DispatchCounts& counts) {
  MetricFamily family{
      "slicefarm_ranges_total", "Layer ranges by their result", MetricType::Counter, {}};
  for (const auto& [outcome, count] : {std::pair{"ok", counts.done},
                                       {"requeued", counts.requeued},
                                       {"hedged", counts.hedged},
                                       {"poisoned", counts.poisoned},
                                       {"differing", counts.differing}}) {
    family.metric.push_back(
        Value(MetricType::Counter, static_cast<double>(count), "outcome", outcome));
  }
  return family;
}

/// Returns the number of waiting ranges. Autoscalers use it together with the number of busy slots.
MetricFamily Waiting(const DispatchCounts& counts) {
  return Gauge("slicefarm_ranges_waiting", "Layer ranges that no worker processes yet",
               static_cast<double>(counts.waiting));
}

MetricFamily Presets(const CoordinatorMetrics::PresetUses& uses) {
  MetricFamily family{"slicefarm_preset_sets_total",
                      "Uses of sets of presets by jobs and calls, by where the sets were",
                      MetricType::Counter,
                      {}};
  for (const auto& [from, count] :
       {std::pair{"memory", uses.from_memory}, {"store", uses.from_store}})
    family.metric.push_back(Value(MetricType::Counter, static_cast<double>(count), "from", from));
  return family;
}

void AddFleet(const Fleet& fleet, std::vector<MetricFamily>& families) {
  int slots = 0;
  int busy = 0;
  const auto runners = fleet.Runners();
  for (const RunnerAtWork& runner : runners) {
    slots += runner.slots;
    busy += static_cast<int>(runner.tasks.size());
  }
  families.push_back(
      Gauge("slicefarm_workers", "Workers that have joined", static_cast<double>(runners.size())));
  families.push_back({"slicefarm_worker_slots",
                      "Ranges that the connected workers can process at the same time",
                      MetricType::Gauge,
                      {Value(MetricType::Gauge, busy, "state", "busy"),
                       Value(MetricType::Gauge, std::max(slots - busy, 0), "state", "idle")}});
}

MetricFamily StagesUp(const std::map<std::string, bool>& stages) {
  MetricFamily family{"slicefarm_stage_up",
                      "1 if a server of the stage can be reached, else 0",
                      MetricType::Gauge,
                      {}};
  for (const auto& [stage, up] : stages)
    family.metric.push_back(Value(MetricType::Gauge, up ? 1 : 0, "stage", stage));
  return family;
}

void AddDisk(const std::string& directory, std::vector<MetricFamily>& families) {
  const auto disk = DiskOf(directory);
  if (!disk) return;
  families.push_back(Gauge("slicefarm_disk_free_bytes", "Free bytes on the disk of the state",
                           static_cast<double>(disk->available)));
  families.push_back(Gauge("slicefarm_disk_size_bytes", "Size of the disk of the state",
                           static_cast<double>(disk->capacity)));
}

void AddDatabase(const DatabaseFill& fill, int64_t max_bytes, std::vector<MetricFamily>& families) {
  const auto add = [&](const char* name, const char* help, int64_t value) {
    families.push_back(Gauge(name, help, static_cast<double>(value)));
  };
  add("slicefarm_database_bytes", "Bytes of the database that are used", fill.bytes);
  if (max_bytes > 0)
    add("slicefarm_database_max_bytes", "Size above which no new data is accepted", max_bytes);
  add("slicefarm_database_connections", "Connections to the database server", fill.connections);
  add("slicefarm_database_max_connections", "Largest number of connections to the database server",
      fill.max_connections);
}

void AddStore(const std::optional<CoordinatorMetrics::StoreFacts>& store, int64_t max_bytes,
              std::vector<MetricFamily>& families) {
  const bool up = store && store->status.ok();
  families.push_back(Gauge("slicefarm_store_up", "1 if the job store answers, else 0", up ? 1 : 0));
  if (!up) return;
  families.push_back(Jobs(store->jobs));
  AddQueue(store->open, families);
  if (store->fill) AddDatabase(*store->fill, max_bytes, families);
  if (store->retention_overdue) {
    families.push_back(
        Gauge("slicefarm_retention_overdue",
              "1 if a job still exists a day after it should have been removed, else 0",
              *store->retention_overdue ? 1 : 0));
  }
}

int64_t UnixUs() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::microseconds>(now).count();
}

/// Returns true if a job still exists a day after the sweep should have removed it. Returns nullopt
/// if jobs are kept forever or if the store fails.
std::optional<bool> RetentionOverdue(JobStore& jobs, double keep_jobs_s) {
  constexpr double kDayS = 24 * 3600;
  if (keep_jobs_s <= 0) return std::nullopt;
  const auto kept_us = static_cast<int64_t>((keep_jobs_s + kDayS) * 1e6);
  const auto overdue = jobs.EndedBefore(UnixUs() - kept_us, 1);
  if (!overdue.ok()) return std::nullopt;
  return !overdue->empty();
}

}  // namespace

std::string PriorityName(Priority priority) {
  switch (priority) {
    case Priority::kBulk:
      return "bulk";
    case Priority::kNormal:
      return "normal";
    case Priority::kInteractive:
      return "interactive";
  }
  return "unknown";
}

std::optional<std::filesystem::space_info> DiskOf(const std::string& directory) {
  if (directory.empty()) return std::nullopt;
  std::error_code error;
  const auto space = std::filesystem::space(directory, error);
  return error ? std::nullopt : std::optional(space);
}

double SecondsSince(int64_t us) { return std::max(0.0, static_cast<double>(UnixUs() - us) / 1e6); }

CoordinatorMetrics::StoreFacts CoordinatorMetrics::LookIntoStore() {
  StoreFacts facts;
  auto open = sources_.jobs.CountOpen();
  auto jobs = open.ok() ? counts_.With(*open) : open.status();
  facts.status = jobs.status();
  if (!facts.status.ok()) return facts;
  facts.open = *std::move(open);
  facts.jobs = *std::move(jobs);
  if (sources_.database_fill) {
    const auto fill = sources_.database_fill();
    if (fill.ok()) facts.fill = *fill;
  }
  facts.retention_overdue = RetentionOverdue(sources_.jobs, sources_.keep_jobs_s);
  return facts;
}

std::vector<MetricFamily> CoordinatorMetrics::Collect() const {
  std::vector<MetricFamily> families;
  AddStore(store_.Get(), sources_.max_database_bytes, families);
  const DispatchCounts ranges = sources_.dispatcher.Counts();
  families.push_back(Ranges(ranges));
  families.push_back(Waiting(ranges));
  AddFleet(sources_.fleet, families);
  AddDisk(sources_.state_dir, families);
  if (sources_.preset_uses) families.push_back(Presets(sources_.preset_uses()));
  if (sources_.stages_up) families.push_back(StagesUp(sources_.stages_up()));
  return families;
}

}  // namespace slicefarm::coordinator
