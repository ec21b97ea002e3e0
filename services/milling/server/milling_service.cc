#include "services/milling/server/milling_service.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "common/model/limits.h"
#include "common/rpc/server/server_stream.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/milling.grpc.pb.h"

namespace slicefarm::milling {
namespace {

/// What a message of text holds at most.
constexpr size_t kTextBytes = 1 << 20;

/// The steps that follow a start.
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

class MillingService final : public v1::Milling::Service {
 public:
  MillingService(const MillingStage& stage, rpc::CallGate& gate, SharedCache& shared)
      : stage_(stage), gate_(gate), shared_(shared) {}

  grpc::Status LayOutSteps(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::MillLayout, v1::MillRequest>* stream) override;
  grpc::Status MillSteps(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::MilledStep, v1::MillRequest>* stream) override;
  grpc::Status AssembleProgram(
      grpc::ServerContext* context,
      grpc::ServerReaderWriter<v1::MillProgramPart, v1::MillRequest>* stream) override;

 private:
  using LayoutStream = rpc::ServerStream<v1::MillLayout, v1::MillRequest>;
  using StepStream = rpc::ServerStream<v1::MilledStep, v1::MillRequest>;
  using ProgramStream = rpc::ServerStream<v1::MillProgramPart, v1::MillRequest>;
  absl::Status LayOut(rpc::Call& call, LayoutStream& stream) const;
  absl::Status Mill(rpc::Call& call, StepStream& stream) const;
  absl::Status Assemble(rpc::Call& call, ProgramStream& stream) const;
  static absl::Status Answer(const MilledProgram& program, ProgramStream& stream);

  const MillingStage& stage_;
  rpc::CallGate& gate_;
  SharedCache& shared_;
};

}  // namespace

grpc::Status MillingService::LayOutSteps(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::MillLayout, v1::MillRequest>* stream) {
  LayoutStream buffered(*stream);
  return gate_.Run(*context, "LayOutSteps",
                   [&](rpc::Call& call) { return LayOut(call, buffered); });
}

absl::Status MillingService::LayOut(rpc::Call& call, LayoutStream& stream) const {
  absl::StatusOr<MillStart> start = ReadStart<v1::MillRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto input = TakeShared<MillInput>(shared_, start->shared, "start.shared");
  if (!input.ok()) return input.status();
  call.job_id = start->call.job_id;
  const auto layout = stage_.LayOut(start->call, *input);
  if (!layout.ok()) return layout.status();
  v1::MillLayout response;
  if (absl::Status put = ToProto(*layout, &response); !put.ok()) return put;
  stream.Write(response);
  return absl::OkStatus();
}

grpc::Status MillingService::MillSteps(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::MilledStep, v1::MillRequest>* stream) {
  StepStream buffered(*stream);
  return gate_.Run(*context, "MillSteps", [&](rpc::Call& call) { return Mill(call, buffered); });
}

absl::Status MillingService::Mill(rpc::Call& call, StepStream& stream) const {
  absl::StatusOr<MillStart> start = ReadStart<v1::MillRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto input = TakeShared<MillInput>(shared_, start->shared, "start.shared");
  if (!input.ok()) return input.status();
  call.job_id = start->call.job_id;
  call.about = {{"step_first", start->range.first}, {"step_last", start->range.last - 1}};
  const auto steps = stage_.Mill(start->call, *input, start->range);
  if (!steps.ok()) return steps.status();
  return WriteEach<v1::MilledStep>(
      stream, *steps,
      [](const MilledStep& step, v1::MilledStep* proto) { return ToProto(step, proto); });
}

grpc::Status MillingService::AssembleProgram(
    grpc::ServerContext* context,
    grpc::ServerReaderWriter<v1::MillProgramPart, v1::MillRequest>* stream) {
  ProgramStream buffered(*stream);
  return gate_.Run(*context, "AssembleProgram",
                   [&](rpc::Call& call) { return Assemble(call, buffered); });
}

absl::Status MillingService::Assemble(rpc::Call& call, ProgramStream& stream) const {
  absl::StatusOr<MillStart> start = ReadStart<v1::MillRequest>(stream, call.cancel);
  if (!start.ok()) return start.status();
  const auto input = TakeShared<MillInput>(shared_, start->shared, "start.shared");
  if (!input.ok()) return input.status();
  call.job_id = start->call.job_id;
  auto steps = ReadSteps(stream, *start);
  if (!steps.ok()) return steps.status();
  const auto program =
      stage_.Assemble(start->call, *input, *std::move(steps), start->settings_text);
  if (!program.ok()) return program.status();
  return Answer(*program, stream);
}

absl::Status MillingService::Answer(const MilledProgram& program, ProgramStream& stream) {
  v1::MillProgramPart part;
  if (absl::Status put = ToProto(program.report, part.mutable_summary()); !put.ok()) return put;
  bool there = stream.Write(part);  // that the client is gone says its call
  for (size_t at = 0; there && at < program.text.size(); at += kTextBytes) {
    part.set_text(program.text.substr(at, kTextBytes));
    there = stream.Write(part);
  }
  return absl::OkStatus();
}

std::unique_ptr<grpc::Service> MakeMillingService(const MillingStage& stage, rpc::CallGate& gate,
                                                  SharedCache& shared) {
  return std::make_unique<MillingService>(stage, gate, shared);
}

}  // namespace slicefarm::milling
