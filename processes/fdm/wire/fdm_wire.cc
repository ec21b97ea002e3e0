#include "processes/fdm/wire/fdm_wire.h"

#include <utility>

#include "common/stage/object_layers.h"
#include "common/wire/layers/fill_stats_wire.h"
#include "common/wire/process_wire.h"
#include "processes/fdm/wire/fdm_work.h"

namespace slicefarm {
namespace {

struct FdmTraits {
  using Task = FdmTask;
  using Result = FdmResult;
  using Payload = FdmWork;
  static constexpr auto kWork = v1::WorkStart::kFdm;
  static constexpr auto kShared = &FdmTask::job;

  static int64_t PointsIn(const FdmTask& task) { return slicefarm::PointsIn(task.layers); }

  static absl::Status Put(const FdmTask& task, v1::WorkStart* start) {
    return ToProto(FdmWork{task.range, {task.plans.begin(), task.plans.end()}},
                   start->mutable_fdm());
  }
  static absl::StatusOr<FdmWork> Take(const v1::WorkStart& start) { return FromProto(start.fdm()); }
  static FdmTask TaskOf(const FdmWork& payload) { return {payload.range, {}, payload.plans, {}}; }

  static absl::Status SendParts(FdmResult& result, WorkerEnd& end) {
    absl::Status status = WriteEach<v1::WorkResponse>(
        end, result.programs, [](LayerProgram& program, v1::WorkResponse* response) {
          return ToProto(std::move(program), response->mutable_program());
        });
    if (!status.ok()) return status;
    status = WriteEach<v1::WorkResponse>(
        end, result.warnings, [](const LayerWarning& warning, v1::WorkResponse* response) {
          *response->mutable_warning() = ToProto(warning);
          return absl::OkStatus();
        });
    if (!status.ok()) return status;
    return WriteEach<v1::WorkResponse>(end, result.fills,
                                       [](const FillStats& use, v1::WorkResponse* response) {
                                         return ToProto(use, response->mutable_fill());
                                       });
  }
  static absl::Status TakePart(v1::WorkResponse& response, FdmResult* result) {
    if (response.has_warning()) return Append(FromProto(response.warning()), &result->warnings);
    if (response.has_fill()) return Append(FromProto(response.fill()), &result->fills);
    return Append(FromProto(std::move(*response.mutable_program())), &result->programs);
  }
  static absl::Status Check(const FdmTask& task, const FdmResult& result) {
    return CheckProgramsOfRange(result.programs, task.range);
  }
};

}  // namespace

const TaskWire& FdmWire() {
  static const ProcessWire<FdmTraits> wire;
  return wire;
}

}  // namespace slicefarm
