#include "services/milling/server/milling_service.h"

#include <utility>
#include <vector>

#include "common/model/limits.h"
#include "common/rpc/server/limited_service.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/stage_answer.h"
#include "slicefarm/v1/milling.grpc.pb.h"

namespace slicefarm::milling {
namespace {

/// Largest size of a text message.
constexpr size_t kTextBytes = 1 << 20;

/// Reads the steps that follow a start.
template <typename Stream>
absl::StatusOr<std::vector<MilledStep>> ReadSteps(Stream& stream, const MillStart& start) {
  std::vector<MilledStep> steps;
  absl::Status read = ReadEach<v1::MillRequest>(stream, [&](const v1::MillRequest& request) {
    if (std::ssize(steps) == start.step_count) return Malformed("step", "more than announced");
    return Append(FromProto(request.step()), &steps);
  });
  read.Update(start.call.cancel.Check());
  if (!read.ok()) return read;
  if (std::ssize(steps) < start.step_count) return Malformed("step", "fewer than announced");
  return steps;
}

template <typename Stream>
absl::Status Mill(const MillingStage& stage, rpc::Call& call, Stream& stream, SharedCache& shared) {
  const auto begun = BeginCall<MillInput>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  const StepRange range = begun->start.range;
  call.about = {{"step_first", range.first}, {"step_last", range.last - 1}};
  return AnswerEach(stream, stage.Mill(begun->start.call, begun->job, range));
}

template <typename Stream>
absl::Status Answer(const MilledProgram& program, Stream& stream) {
  v1::MillProgramPart part;
  if (absl::Status put = ToProto(program.report, part.mutable_summary()); !put.ok()) return put;
  bool there = stream.Write(part);  // a gone client is reported by its call
  for (size_t at = 0; there && at < program.text.size(); at += kTextBytes) {
    part.set_text(program.text.substr(at, kTextBytes));
    there = stream.Write(part);
  }
  return absl::OkStatus();
}

template <typename Stream>
absl::Status Assemble(const MillingStage& stage, rpc::Call& call, Stream& stream,
                      SharedCache& shared) {
  const auto begun = BeginCall<MillInput>(call, stream, shared);
  if (!begun.ok()) return begun.status();
  const auto& [start, input] = *begun;
  auto steps = ReadSteps(stream, start);
  if (!steps.ok()) return steps.status();
  const auto program = stage.Assemble(start.call, input, *std::move(steps), start.settings_text);
  if (!program.ok()) return program.status();
  return Answer(*program, stream);
}

}  // namespace

std::unique_ptr<grpc::Service> MakeMillingService(const MillingStage& stage, rpc::CallLimiter& gate,
                                                  SharedCache& shared) {
  auto service = std::make_unique<rpc::LimitedService<v1::Milling>>(gate);
  service->Add("LayOutSteps", &v1::Milling::Service::LayOutSteps,
               [&](rpc::Call& call, auto& stream) -> absl::Status {
                 const auto begun = BeginCall<MillInput>(call, stream, shared);
                 if (!begun.ok()) return begun.status();
                 return AnswerOne(stream, stage.LayOut(begun->start.call, begun->job));
               });
  service->Add("MillSteps", &v1::Milling::Service::MillSteps,
               [&](rpc::Call& call, auto& stream) { return Mill(stage, call, stream, shared); });
  service->Add(
      "AssembleProgram", &v1::Milling::Service::AssembleProgram,
      [&](rpc::Call& call, auto& stream) { return Assemble(stage, call, stream, shared); });
  return service;
}

}  // namespace slicefarm::milling
