#pragma once

#include <cstdint>
#include <memory>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/base/shared/shared_cache.h"
#include "common/stage/task.h"
#include "slicefarm/v1/worker.pb.h"

namespace slicefarm {

/// One end of a call with messages both ways. Both methods tell by false that there is no more.
template <typename In, typename Out>
class MessageChannel {
 public:
  virtual ~MessageChannel() = default;
  virtual bool Read(In* message) = 0;
  virtual bool Write(const Out& message) = 0;
};

/// A stream of gRPC, or what looks like one, as a channel. It must outlive the channel.
template <typename In, typename Out, typename Stream>
class ChannelOf : public MessageChannel<In, Out> {
 public:
  explicit ChannelOf(Stream& stream) : stream_(stream) {}
  bool Read(In* message) override { return stream_.Read(message); }
  bool Write(const Out& message) override { return stream_.Write(message); }

 private:
  Stream& stream_;
};

using WorkerEnd = MessageChannel<v1::WorkRequest, v1::WorkResponse>;
using CoordinatorEnd = MessageChannel<v1::WorkResponse, v1::WorkRequest>;

/// A task that came over the wire, and all that it points into.
class ReceivedTask {
 public:
  virtual ~ReceivedTask() = default;
  /// It points into this object.
  virtual Task task() const = 0;
};

/// The tasks of one process on the wire, and what they come to. One object a process, in
/// processes/<name>/wire; processes/list/wire.h lists them.
class TaskWire {
 public:
  virtual ~TaskWire() = default;

  /// Whether what a call begins with is a task of this process.
  virtual bool IsIn(const v1::WorkStart& start) const = 0;

  // At the coordinator's end.
  /// Of outlines: what the time of a call depends on.
  virtual int64_t PointsIn(const Task& task) const = 0;
  /// What the start names: what the job's tasks have in common. Made once a job.
  virtual absl::StatusOr<SharedParts> PartsOf(const Task& task) const = 0;
  /// OK if it is all written, or the peer is gone.
  virtual absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const = 0;
  /// Until there is no more. Errors: REQUEST_MALFORMED.
  virtual absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const = 0;
  /// Whether a result is one of this task. Errors: REQUEST_MALFORMED.
  virtual absl::Status Check(const Task& task, const TaskResult& result) const = 0;

  // At the worker's end.
  /// `start`: the first message, which IsIn; the rest is read from `end`. Errors: SHARED_MISSING;
  /// REQUEST_MALFORMED and REQUEST_TOO_LARGE with the way to the field; `cancel`'s.
  virtual absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                                SharedCache& shared,
                                                                const CancelToken& cancel,
                                                                WorkerEnd& end) const = 0;
  /// Unavailable if the peer takes no more.
  virtual absl::Status SendResult(TaskResult result, WorkerEnd& end) const = 0;
};

}  // namespace slicefarm
