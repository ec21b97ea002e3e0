#include "processes/engrave/wire/engrave_wire.h"

#include "common/wire/engraving/engrave_input_wire.h"
#include "common/wire/engraving/engraved_wire.h"
#include "common/wire/process_wire.h"
#include "processes/engrave/task/engrave_task.h"

namespace slicefarm {
namespace {

struct EngraveTraits {
  using Task = EngraveTask;
  using Result = EngraveResult;
  using Payload = EngraveTask;
  static constexpr auto kWork = v1::WorkStart::kEngrave;
  static constexpr auto kShared = &EngraveTask::input;

  /// Returns the approximate number of points of a task. Lines cross each triangle many times.
  static int64_t PointsIn(const EngraveTask& task) {
    constexpr int64_t kPointsATriangle = 400;
    return kPointsATriangle * std::ssize(task.input->surface.mesh.triangles);
  }

  static absl::Status Put(const EngraveTask& task, v1::WorkStart* start) {
    *start->mutable_engrave()->mutable_range() = ToProto(task.range);
    return absl::OkStatus();
  }
  static absl::StatusOr<EngraveTask> Take(const v1::WorkStart& start) {
    const absl::StatusOr<LayerRange> range = FromProto(start.engrave().range());
    if (!range.ok()) return range.status();
    return EngraveTask{*range, {}};
  }
  static EngraveTask TaskOf(const EngraveTask& payload) { return payload; }

  static absl::Status SendParts(const EngraveResult& result, WorkerEnd& end) {
    v1::WorkResponse response;
    for (const EngravedLayer& layer : result.layers) {
      absl::Status sent = SendPieces(layer, [&](const v1::EngravedPiece& piece) {
        *response.mutable_engraved() = piece;
        return end.Write(response);
      });
      if (!sent.ok()) return sent;
    }
    return absl::OkStatus();
  }
  static absl::Status TakePart(const v1::WorkResponse& response, EngraveResult* result) {
    return TakePiece(response.engraved(), &result->layers);
  }
  static absl::Status Check(const EngraveTask& task, const EngraveResult& result) {
    return std::ssize(result.layers) == task.range.size()
               ? absl::OkStatus()
               : Malformed("engraved", "not a layer for each of the range");
  }
};

}  // namespace

const TaskWire& EngraveWire() {
  static const ProcessWire<EngraveTraits> wire;
  return wire;
}

}  // namespace slicefarm
