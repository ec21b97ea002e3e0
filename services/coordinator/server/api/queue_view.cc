#include "services/coordinator/server/api/queue_view.h"

#include <google/protobuf/util/time_util.h>

#include <unordered_map>
#include <utility>

#include "services/coordinator/algo/queue_order.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::chrono::milliseconds kPatience{500};
constexpr double kKeptFor = 20;  ///< validity of a snapshot, as a multiple of the time that it took

void SetEnd(int64_t end_us, v1::Job& answer) {
  *answer.mutable_estimated_end_time() =
      google::protobuf::util::TimeUtil::MicrosecondsToTimestamp(end_us);
}

}  // namespace

struct QueueView::Look {
  struct QueuePosition {
    int32_t position = 0;
    int64_t end_us = 0;
  };

  Stopwatch since;
  double took_s = 0;
  bool runs = false;   ///< true if the farm works on a job
  int64_t run_us = 0;  ///< mean time of a run; 0 if it is unknown
  std::set<std::string> held_work;
  std::unordered_map<int64_t, QueuePosition> positions;  ///< expected positions, by job number

  static std::shared_ptr<const Look> At(JobStore& jobs, int64_t now_us) {
    auto look = std::make_shared<Look>();
    auto queue = jobs.ReadQueue(now_us);
    if (!queue.ok()) return nullptr;
    look->runs = !queue->held.empty();
    look->run_us = MeanRunUs(*queue);
    int32_t position = 0;
    for (const ExpectedRun& run : ExpectedRuns(*queue, now_us))
      look->positions[run.number] = {++position, run.end_us};
    look->held_work = std::move(queue->held_work);
    look->took_s = look->since.Seconds();
    return look;
  }
};

QueueView::QueueView(JobStore& jobs, std::function<int64_t()> now_us)
    : now_us_(std::move(now_us)),
      look_([this, &jobs] { return Look::At(jobs, now_us_()); }, kPatience) {}

std::shared_ptr<const QueueView::Look> QueueView::Latest() {
  {
    const std::lock_guard lock(mutex_);
    if (latest_ && latest_->since.Seconds() < kKeptFor * latest_->took_s) return latest_;
  }
  auto found = look_.Get().value_or(nullptr);
  const std::lock_guard lock(mutex_);
  latest_ = found;
  return found;
}

void QueueView::Describe(const JobRecord& job, v1::Job& answer) {
  if (job.state == JobState::kQueued) DescribeQueued(job, answer);
  if (job.state == JobState::kRunning) DescribeRunning(job, answer);
}

void QueueView::DescribeQueued(const JobRecord& job, v1::Job& answer) {
  const bool waits_for_attempt = job.owner.empty() && job.owner_until_us > now_us_();
  if (waits_for_attempt || job.cancel_requested) return;
  const auto look = Latest();
  if (!look || look->held_work.contains(job.action_digest)) return;
  const auto found = look->positions.find(job.number);
  if (found == look->positions.end()) return;
  answer.set_queue_position(found->second.position);
  if (look->runs && look->run_us > 0) SetEnd(found->second.end_us, answer);
}

/// Estimates the end of a running job from its finished layers. Before the first finished layer,
/// uses the mean time of other jobs.
void QueueView::DescribeRunning(const JobRecord& job, v1::Job& answer) {
  const int64_t now_us = now_us_();
  if (job.start_us == 0 || job.start_us > now_us) return;
  if (job.layers_done > 0) {
    const int64_t elapsed_us = now_us - job.start_us;
    SetEnd(job.start_us + elapsed_us / job.layers_done * job.layers_total, answer);
    return;
  }
  const auto look = Latest();
  if (look && look->run_us > 0 && job.start_us + look->run_us > now_us)
    SetEnd(job.start_us + look->run_us, answer);
}

}  // namespace slicefarm::coordinator
