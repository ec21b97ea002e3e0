#include "processes/engrave/wire/engrave_wire.h"

#include <utility>

#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/message_stream.h"
#include "common/wire/work_layers.h"
#include "processes/engrave/task/engrave_task.h"

namespace slicefarm {
namespace {

class ReceivedEngrave : public ReceivedTask {
 public:
  explicit ReceivedEngrave(EngraveTask task) : task_(std::move(task)) {}
  Task task() const override { return task_; }

 private:
  const EngraveTask task_;
};

class WireOfEngrave : public TaskWire {
 public:
  bool IsIn(const v1::WorkStart& start) const override { return start.has_engrave(); }

  /// Lines pass each triangle many times.
  int64_t PointsIn(const Task& task) const override {
    constexpr int64_t kPointsATriangle = 400;
    return kPointsATriangle * std::ssize(task.As<EngraveTask>().input->surface.mesh.triangles);
  }

  absl::StatusOr<SharedParts> PartsOf(const Task& task) const override {
    return OnePart(task.As<EngraveTask>().input);
  }

  absl::Status Send(const StageCall& call, const Task& task, CoordinatorEnd& end) const override {
    const auto& engrave = task.As<EngraveTask>();
    const auto& part = PartOf(engrave.input);
    if (!part.ok()) return part.status();
    v1::WorkRequest start;
    *start.mutable_start()->mutable_call() = ToProto(call);
    v1::EngraveWork* work = start.mutable_start()->mutable_engrave();
    work->set_shared((*part)->digest);
    *work->mutable_range() = ToProto(engrave.range);
    end.Write(start);  // that the peer is gone says the call
    return absl::OkStatus();
  }

  absl::StatusOr<TaskResult> ReceiveResult(CoordinatorEnd& end) const override {
    EngraveResult result;
    const absl::Status read = ReadEach<v1::WorkResponse>(end, [&](v1::WorkResponse& response) {
      return response.has_engraved() ? TakePiece(response.engraved(), &result.layers)
                                     : TakeTimes(response, &result.times);
    });
    if (!read.ok()) return read;
    return TaskResult(std::move(result));
  }

  absl::Status Check(const Task& task, const TaskResult& result) const override {
    const int32_t want = task.As<EngraveTask>().range.size();
    return std::ssize(result.As<EngraveResult>().layers) == want
               ? absl::OkStatus()
               : Malformed("engraved", "not a layer for each of the range");
  }

  absl::StatusOr<std::unique_ptr<ReceivedTask>> Receive(const v1::WorkStart& start,
                                                        SharedCache& shared,
                                                        const CancelToken& /*cancel*/,
                                                        WorkerEnd& /*end*/) const override {
    const v1::EngraveWork& work = start.engrave();
    const absl::StatusOr<LayerRange> range = FromProto(work.range());
    if (!range.ok()) return Within("start", Within("engrave", Within("range", range.status())));
    absl::StatusOr<Shared<EngraveInput>> input =
        TakeShared<EngraveInput>(shared, work.shared(), "start.engrave.shared");
    if (!input.ok()) return input.status();
    return std::make_unique<ReceivedEngrave>(EngraveTask{*range, *std::move(input)});
  }

  absl::Status SendResult(TaskResult task_result, WorkerEnd& end) const override {
    const auto& result = task_result.As<EngraveResult>();
    v1::WorkResponse response;
    for (const EngravedLayer& layer : result.layers) {
      absl::Status sent = SendPieces(layer, [&](const v1::EngravedPiece& piece) {
        *response.mutable_engraved() = piece;
        return end.Write(response);
      });
      if (!sent.ok()) return sent;
    }
    SendTimes(result.times, end);
    return absl::OkStatus();
  }
};

}  // namespace

const TaskWire& EngraveWire() {
  static const WireOfEngrave wire;
  return wire;
}

}  // namespace slicefarm
