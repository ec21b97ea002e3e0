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

/// One end of a call with messages in both directions. Read returns false if there are no more
/// messages, Write if the peer has disconnected.
template <typename In, typename Out>
class MessageChannel {
 public:
  virtual ~MessageChannel() = default;
  virtual bool Read(In* message) = 0;
  virtual bool Write(const Out& message) = 0;
};

/// Channel that uses a gRPC stream or an object with the same interface. The stream must outlive
/// the channel.
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

/// Received task with all data to which it points.
class ReceivedTask {
 public:
  virtual ~ReceivedTask() = default;
  /// Returns the task, which points into this object.
  virtual Task task() const = 0;
};

/// Messages for the tasks of one process and for their results. Each process has one object of this
/// class, in processes/<name>/wire; processes/list/wire.h lists these objects.
class TaskWire {
 public:
  virtual ~TaskWire() = default;

  /// Returns true if the first message of a call contains a task of this process.
  virtual bool IsIn(const v1::WorkStart& start) const = 0;

  // Functions for the coordinator.
  /// Returns the number of outline points of the task, which determines the duration of a call.
  virtual int64_t PointsIn(const Task& task) const = 0;
  /// Returns the shared data of the job's tasks, to which the first message refers by digest. It is
  /// called once per job.
  virtual absl::StatusOr<SharedParts> PartsOf(const Task& task) const = 0;
  /// Sends a task. Returns OK if all messages are written, or if the peer has disconnected.
  virtual absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const = 0;
  /// Reads the result until there are no more messages. Errors: REQUEST_MALFORMED.
  virtual absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const = 0;
  /// Checks that a result belongs to this task. Errors: REQUEST_MALFORMED.
  virtual absl::Status Check(const Task& task, const TaskResult& result) const = 0;

  // Functions for the worker.
  /// Reads a task. `start`: the first message, for which IsIn is true; further messages are read
  /// from `end`. Errors: SHARED_MISSING; REQUEST_MALFORMED and REQUEST_TOO_LARGE with the path to
  /// the field; the error of `cancel`.
  virtual absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                                SharedCache& shared,
                                                                const CancelToken& cancel,
                                                                WorkerEnd& end) const = 0;
  /// Sends a result. Errors: Unavailable if the peer has stopped reading.
  virtual absl::Status SendResult(TaskResult result, WorkerEnd& end) const = 0;
};

}  // namespace slicefarm
