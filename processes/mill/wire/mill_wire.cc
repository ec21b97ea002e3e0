#include "processes/mill/wire/mill_wire.h"

#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/process_wire.h"
#include "processes/mill/wire/mill_work.h"

namespace slicefarm {
namespace {

struct MillTraits {
  using Task = MillTask;
  using Result = MillResult;
  using Payload = MillTask;
  static constexpr auto kWork = v1::WorkStart::kMill;
  static constexpr auto kShared = &MillTask::input;

  /// Returns the approximate number of points of a task. Triangles have no outlines yet; each
  /// triangle is cut about 100 times.
  static int64_t PointsIn(const MillTask& task) {
    constexpr int64_t kPointsATriangle = 100;
    return kPointsATriangle * std::ssize(task.input->part.triangles);
  }

  static absl::Status Put(const MillTask& task, v1::WorkStart* start) {
    return ToProto(task, start->mutable_mill());
  }
  static absl::StatusOr<MillTask> Take(const v1::WorkStart& start) {
    return FromProto(start.mill());
  }
  static MillTask TaskOf(const MillTask& payload) { return payload; }

  static absl::Status SendParts(const MillResult& result, WorkerEnd& end) {
    return WriteEach<v1::WorkResponse>(end, result.steps,
                                       [](const MilledStep& step, v1::WorkResponse* response) {
                                         return ToProto(step, response->mutable_milled());
                                       });
  }
  static absl::Status TakePart(const v1::WorkResponse& response, MillResult* result) {
    return Append(FromProto(response.milled()), &result->steps);
  }
  static absl::Status Check(const MillTask& task, const MillResult& result) {
    return std::ssize(result.steps) == task.steps.size()
               ? absl::OkStatus()
               : Malformed("milled", "not a step for each of the range");
  }
};

}  // namespace

const TaskWire& MillWire() {
  static const ProcessWire<MillTraits> wire;
  return wire;
}

}  // namespace slicefarm
