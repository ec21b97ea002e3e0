#pragma once

#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/shared/shared_cache.h"
#include "common/wire/layers/message_stream.h"
#include "common/wire/shared_wire.h"

namespace slicefarm {

// Server side of a stage's call that refers to its job data by digest. Requirements: the type Call
// has the members `cancel` and `job_id` (for the log), such as rpc::Call. The type Stream has the
// types Request and Response.

/// First message of a call, and the job data to which it refers.
template <typename Start, typename Job>
struct BegunCall {
  Start start;
  Shared<Job> job;
};

/// Reads the first message of a call, and takes its job data from `shared`. Errors: any error of
/// ReadStart and TakeShared.
template <typename Job, typename Call, typename Stream>
auto BeginCall(Call& call, Stream& stream, SharedCache& shared) {
  auto start = ReadStart<typename Stream::Request>(stream, call.cancel);
  using Begun = BegunCall<typename decltype(start)::value_type, Job>;
  if (!start.ok()) return absl::StatusOr<Begun>(start.status());
  call.job_id = start->call.job_id;
  auto job = TakeShared<Job>(shared, start->shared, "start.shared");
  if (!job.ok()) return absl::StatusOr<Begun>(job.status());
  return absl::StatusOr<Begun>(Begun{*std::move(start), *std::move(job)});
}

/// Reads the first message of a call about a range of layers, and its job data (BeginCall). The
/// range is also written to the log. Errors: any error of BeginCall; REQUEST_MALFORMED if the
/// message has no range.
template <typename Job, typename Call, typename Stream>
auto BeginRange(Call& call, Stream& stream, SharedCache& shared) {
  auto begun = BeginCall<Job>(call, stream, shared);
  if (!begun.ok()) return begun;
  call.layers = begun->start.range;
  if (call.layers.empty()) begun = Malformed("start.range", "is missing");
  return begun;
}

/// Answers with one message. A disconnected client causes no error.
template <typename Stream, typename Model>
absl::Status AnswerOne(Stream& stream, const absl::StatusOr<Model>& model) {
  if (!model.ok()) return model.status();
  typename Stream::Response response;
  absl::Status put = ToProto(*model, &response);
  if (put.ok()) stream.Write(response);
  return put;
}

/// Answers with a message for each model. Errors: Unavailable if the client has disconnected.
template <typename Stream, typename Model>
absl::Status AnswerEach(Stream& stream, absl::StatusOr<std::vector<Model>> models) {
  if (!models.ok()) return models.status();
  return WriteEach<typename Stream::Response>(
      stream, *models, [](Model& model, typename Stream::Response* response) {
        return ToProto(std::move(model), response);
      });
}

}  // namespace slicefarm
