#include "processes/laser/wire/laser_wire.h"

#include <utility>

#include "common/stage/object_layers.h"
#include "common/wire/layers/exposure_wire.h"
#include "common/wire/process_wire.h"
#include "common/wire/stage_jobs_wire.h"
#include "processes/laser/task/laser_task.h"

namespace slicefarm {
namespace {

struct LaserTraits {
  using Task = LaserTask;
  using Result = LaserResult;
  using Payload = LaserTask;
  static constexpr auto kWork = v1::WorkStart::kLaser;
  static constexpr auto kShared = &LaserTask::job;

  static int64_t PointsIn(const LaserTask& task) { return slicefarm::PointsIn(task.layers); }

  static absl::Status Put(const LaserTask& task, v1::WorkStart* start) {
    *start->mutable_laser()->mutable_range() = ToProto(task.range);
    return absl::OkStatus();
  }
  static absl::StatusOr<LaserTask> Take(const v1::WorkStart& start) {
    const absl::StatusOr<LayerRange> range = FromProto(start.laser().range());
    if (!range.ok()) return range.status();
    return LaserTask{*range, {}, {}};
  }
  static LaserTask TaskOf(const LaserTask& payload) { return payload; }

  static absl::Status SendParts(LaserResult& result, WorkerEnd& end) {
    return WriteEach<v1::WorkResponse>(
        end, result.programs, [](ExposedProgram& program, v1::WorkResponse* response) {
          return ToProto(std::move(program), response->mutable_exposed());
        });
  }
  static absl::Status TakePart(v1::WorkResponse& response, LaserResult* result) {
    return Append(FromProto(std::move(*response.mutable_exposed())), &result->programs);
  }
  static absl::Status Check(const LaserTask& task, const LaserResult& result) {
    return CheckLayersOfRange(result.programs, task.range);
  }
};

}  // namespace

const TaskWire& LaserWire() {
  static const ProcessWire<LaserTraits> wire;
  return wire;
}

}  // namespace slicefarm
