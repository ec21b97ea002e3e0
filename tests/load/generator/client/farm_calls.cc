#include "tests/load/generator/client/farm_calls.h"

#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "google/protobuf/util/time_util.h"
#include "tests/load/generator/client/upload_call.h"

namespace slicefarm::load {
namespace {

using google::protobuf::util::TimeUtil;
using std::chrono::steady_clock;

bool HasEnded(const v1::Job& job) {
  return job.state() == v1::JOB_STATE_SUCCEEDED || job.state() == v1::JOB_STATE_FAILED ||
         job.state() == v1::JOB_STATE_CANCELLED;
}

/// Makes a unary call with its attempts.
template <typename Response, typename Request, typename Start>
void Unary(std::string_view step, const CallContext& context, const Request& request, Start start,
           Then<Response> then) {
  auto response = std::make_shared<Response>();
  MakeCall(
      step, context,
      [context, request, start, response](Ended ended) {
        StartUnary<Response>(context, request, start,
                             [response, ended](absl::StatusOr<Response> answer) {
                               if (answer.ok()) *response = *std::move(answer);
                               ended(answer.status());
                             });
      },
      [response, then = std::move(then)](absl::Status status) {
        if (status.ok()) return then(std::move(*response));
        then(std::move(status));
      });
}

/// State of a watch over all its attempts.
struct Watch {
  v1::WatchJobRequest request;
  v1::Job last;
  google::protobuf::Timestamp begin = TimeUtil::GetCurrentTime();
  steady_clock::time_point start = steady_clock::now();
};

void TakeEvent(const v1::JobEvent& event, Watch& watch, RunLog& log) {
  log.Add(Tally::kEvents);
  watch.request.set_after_sequence(event.sequence());
  watch.last = event.job();
  if (event.time() < watch.begin) return;  // the event is older than the watch
  const auto path = TimeUtil::GetCurrentTime() - event.time();
  log.StepTook("Event", TimeUtil::DurationToNanoseconds(path));
}

void StartWatch(v1::Jobs::Stub& stub, const CallContext& context,
                const std::shared_ptr<Watch>& watch, Ended ended) {
  using Reader = StreamReader<v1::JobEvent>;
  Reader::Handler handler;
  handler.opened = [watch, log = context.log] {
    const std::chrono::nanoseconds took = steady_clock::now() - watch->start;
    log->StepTook("WatchOpen", took.count());
  };
  handler.take = [watch, log = context.log](const v1::JobEvent& event) {
    TakeEvent(event, *watch, *log);
  };
  handler.ended = [watch, ended = std::move(ended)](absl::Status status) {
    if (!status.ok() || HasEnded(watch->last)) return ended(std::move(status));
    ended(MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                    "the server ended the stream of job states before the job had ended"));
  };
  Reader::Run(
      context,
      [&](grpc::ClientContext* call, Reader* reader) {
        stub.async()->WatchJob(call, &watch->request, reader);
      },
      std::move(handler));
}

/// State of a download over all its attempts.
struct Fetch {
  v1::DownloadRequest request;
  Sha256 digest;
};

void StartDownload(v1::Jobs::Stub& stub, const CallContext& context,
                   const std::shared_ptr<Fetch>& fetch, Ended ended) {
  using Reader = StreamReader<v1::DownloadResponse>;
  Reader::Handler handler;
  handler.take = [fetch, log = context.log](const v1::DownloadResponse& response) {
    const auto bytes = static_cast<int64_t>(response.data().size());
    log->Add(Tally::kBytesReceived, bytes);
    fetch->request.set_offset(fetch->request.offset() + bytes);
    fetch->digest.Add(response.data());
  };
  handler.ended = std::move(ended);
  Reader::Run(
      context,
      [&](grpc::ClientContext* call, Reader* reader) {
        stub.async()->Download(call, &fetch->request, reader);
      },
      std::move(handler));
}

}  // namespace

FarmCalls::FarmCalls(std::shared_ptr<grpc::Channel> channel)
    : channel_(std::move(channel)),
      meshes_(v1::Meshes::NewStub(channel_)),
      jobs_(v1::Jobs::NewStub(channel_)) {}

void FarmCalls::Upload(const PartPtr& part, const CallContext& context, Ended then) {
  v1::GetUploadRequest request;
  request.set_sha256(part->sha256);
  const auto get = [this](auto... arguments) { meshes_->async()->GetUpload(arguments...); };
  MakeCall(
      "Upload", context,
      [this, part, context, request, get](Ended ended) {
        StartUnary<v1::Upload>(
            context, request, get, [this, part, context, ended](absl::StatusOr<v1::Upload> upload) {
              if (!upload.ok() || upload->complete()) return ended(upload.status());
              StartUpload(*meshes_, part, upload->committed_size(), context, ended);
            });
      },
      std::move(then));
}

void FarmCalls::CreateJob(const v1::CreateJobRequest& request, const CallContext& context,
                          Then<v1::Job> then) {
  Unary<v1::Job>(
      "CreateJob", context, request,
      [this](auto... arguments) { jobs_->async()->CreateJob(arguments...); }, std::move(then));
}

void FarmCalls::GetJob(const std::string& id, const CallContext& context, Then<v1::Job> then) {
  v1::GetJobRequest request;
  request.set_id(id);
  Unary<v1::Job>(
      "GetJob", context, request,
      [this](auto... arguments) { jobs_->async()->GetJob(arguments...); }, std::move(then));
}

void FarmCalls::WatchJob(const std::string& id, const CallContext& context, Then<v1::Job> then) {
  auto watch = std::make_shared<Watch>();
  watch->request.set_id(id);
  MakeCall(
      "WatchJob", context,
      [this, context, watch](Ended ended) { StartWatch(*jobs_, context, watch, std::move(ended)); },
      [watch, then = std::move(then)](absl::Status status) {
        if (status.ok()) return then(std::move(watch->last));
        then(std::move(status));
      });
}

void FarmCalls::Download(const v1::Job& job, const CallContext& context, Ended then) {
  auto fetch = std::make_shared<Fetch>();
  fetch->request.set_id(job.id());
  fetch->request.set_artifact(v1::ARTIFACT_GCODE);
  MakeCall(
      "Download", context,
      [this, context, fetch](Ended ended) {
        StartDownload(*jobs_, context, fetch, std::move(ended));
      },
      [fetch, digest = job.result().gcode_sha256(), then = std::move(then)](absl::Status status) {
        if (status.ok() && fetch->digest.Hex() != digest) {
          status = MakeError(absl::StatusCode::kDataLoss, Reason::kBlobDigestMismatch,
                             "the received G-code differs from the job's result");
        }
        then(std::move(status));
      });
}

}  // namespace slicefarm::load
