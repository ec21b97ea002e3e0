#include "tests/load/generator/client/print_request.h"

#include <mutex>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::load {
namespace {

/// Returns the error of an ended job; OK if it succeeded.
absl::Status JobStatus(const v1::Job& job) {
  if (job.state() == v1::JOB_STATE_SUCCEEDED) return absl::OkStatus();
  if (job.state() == v1::JOB_STATE_CANCELLED) {
    return MakeError(absl::StatusCode::kCancelled, Reason::kCancelled, "the job was cancelled");
  }
  const int code = job.error().code();
  return MakeError(code == 0 ? absl::StatusCode::kUnknown : static_cast<absl::StatusCode>(code),
                   ReasonFromName(job.error().reason()).value_or(Reason::kInternal),
                   job.error().message());
}

/// Request that lives until its last call has ended.
class PrintRequest : public std::enable_shared_from_this<PrintRequest> {
 public:
  PrintRequest(Farm& farm, PrintOrder order, const CallContext& context, Done done)
      : farm_(farm),
        calls_(farm.Next()),
        order_(std::move(order)),
        context_(context),
        done_(std::move(done)),
        watching_(order_.watchers) {}

  void Upload() {
    calls_.Upload(order_.part, context_, [self = shared_from_this()](absl::Status status) {
      if (!status.ok()) return self->End(std::move(status), "Upload");
      self->Create();
    });
  }

 private:
  void Create() {
    const auto request = JobOf(order_.request_id, order_.part->sha256, order_.process);
    order_.part.reset();  // frees megabytes, because the job may be long
    calls_.CreateJob(request, context_, [self = shared_from_this()](absl::StatusOr<v1::Job> job) {
      if (!job.ok()) return self->End(job.status(), "CreateJob");
      self->Watch(job->id());
    });
  }

  void Watch(const std::string& id) {
    for (int i = 0; i < order_.watchers; ++i) {
      FarmCalls& calls = i == 0 ? calls_ : farm_.Next();
      calls.WatchJob(id, context_, [self = shared_from_this()](absl::StatusOr<v1::Job> job) {
        self->WatchEnded(std::move(job));
      });
    }
  }

  void WatchEnded(absl::StatusOr<v1::Job> job) {
    {
      const std::lock_guard lock(mutex_);
      if (watched_.ok() && !job.ok()) watched_ = job.status();
      if (--watching_ > 0) return;
    }
    if (!watched_.ok()) return End(watched_, "WatchJob");
    if (absl::Status status = JobStatus(*job); !status.ok()) return End(std::move(status), "Job");
    if (job->result().cached()) context_.log->Add(Tally::kCachedJobs);
    if (!order_.download) return End(absl::OkStatus(), "");
    calls_.Download(*job, context_, [self = shared_from_this()](absl::Status status) {
      self->End(std::move(status), "Download");
    });
  }

  void End(absl::Status status, std::string step) {
    done_(OutcomeOf(std::move(status), std::move(step)));
  }

  Farm& farm_;
  FarmCalls& calls_;
  PrintOrder order_;
  const CallContext context_;
  const Done done_;

  std::mutex mutex_;
  int watching_;
  absl::Status watched_;
};

}  // namespace

v1::CreateJobRequest JobOf(const std::string& request_id, const std::string& mesh_sha256,
                           v1::Process process) {
  v1::CreateJobRequest request;
  request.set_request_id(request_id);
  request.mutable_spec()->set_process(process);
  v1::Object& object = *request.mutable_spec()->add_objects();
  object.set_mesh_sha256(mesh_sha256);
  object.set_name("load.stl");
  object.set_format(v1::MESH_FORMAT_STL);
  request.mutable_spec()->set_generic(true);
  return request;
}

void StartPrint(Farm& farm, PrintOrder order, const CallContext& context, Done done) {
  std::make_shared<PrintRequest>(farm, std::move(order), context, std::move(done))->Upload();
}

Outcome OutcomeOf(absl::Status status, std::string step) {
  const bool says_when = DetailOf(status).metadata.contains(rpc::kRetryAfterMs);
  return {.status = std::move(status), .step = std::move(step), .says_when_to_retry = says_when};
}

}  // namespace slicefarm::load
