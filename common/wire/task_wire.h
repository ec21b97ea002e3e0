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
/// messages. Write returns false if the peer has disconnected.
template <typename In, typename Out>
class MessageChannel {
 public:
  virtual ~MessageChannel() = default;
  virtual bool Read(In* message) = 0;
  virtual bool Write(const Out& message) = 0;
};

/// Channel over a gRPC stream, or over an object with the same interface. The stream must outlive
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

/// Received task, and the owner of all data to which the task points.
class ReceivedTask {
 public:
  virtual ~ReceivedTask() = default;
  /// Returns the task, which is valid as long as this object exists.
  virtual Task task() const = 0;
};

/// Conversion of one process's tasks and results to messages and back. Each process has one object
/// of this class, in processes/<name>/wire; processes/list/wire.h lists these objects.
class TaskWire {
 public:
  virtual ~TaskWire() = default;

  /// Returns true if the first message of a call contains a task of this process.
  virtual bool IsIn(const v1::WorkStart& start) const = 0;

  // Functions for the coordinator.
  /// Returns the number of outline points of the task. It determines the deadline of the call.
  virtual int64_t PointsIn(const Task& task) const = 0;
  /// Returns the shared data of the job's tasks, to which the first message of each task refers by
  /// digest. Called once per job.
  virtual absl::StatusOr<SharedParts> PartsOf(const Task& task) const = 0;
  /// Sends a task. Returns OK if all messages are written, and also if the peer has disconnected.
  virtual absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const = 0;
  /// Reads the messages of a result until there are no more. Errors: REQUEST_MALFORMED.
  virtual absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const = 0;
  /// Checks that the result belongs to the task. Errors: REQUEST_MALFORMED.
  virtual absl::Status Check(const Task& task, const TaskResult& result) const = 0;

  // Functions for the worker.
  /// Reads a task. `start`: content of the first message, for which IsIn returned true. `shared`:
  /// cache of shared data. Further messages are read from `end`. Errors: SHARED_MISSING;
  /// REQUEST_MALFORMED and REQUEST_TOO_LARGE with the path to the field; CANCELLED.
  virtual absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                                SharedCache& shared,
                                                                const CancelToken& cancel,
                                                                WorkerEnd& end) const = 0;
  /// Sends a result. Errors: Unavailable if the peer has stopped reading.
  virtual absl::Status SendResult(TaskResult result, WorkerEnd& end) const = 0;
};

}  // namespace slicefarm
