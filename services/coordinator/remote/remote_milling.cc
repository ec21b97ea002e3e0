#include "services/coordinator/remote/remote_milling.h"

#include <optional>
#include <string>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/milling.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

constexpr char kMilling[] = "milling";

/// How long a call takes does not follow from the mesh alone: steps may be many and fine.
std::chrono::milliseconds DeadlineOf(const RemoteOptions& options, const MillInput& input) {
  constexpr int64_t kPointsATriangle = 100;
  return 4 * options.DeadlineFor(kPointsATriangle * std::ssize(input.part.triangles));
}

/// `start`, then the meshes.
template <typename Stream>
absl::Status WriteInput(Stream& stream, const v1::MillRequest& start, const MillInput& input) {
  if (!stream.Write(start)) return absl::OkStatus();  // the call's end says why
  return SendMeshes<v1::MillRequest>(input, stream);
}

}  // namespace

absl::StatusOr<MillLayout> RemoteMilling::LayOut(const StageCall& call,
                                                 const MillInput& input) const {
  v1::MillRequest start;
  if (absl::Status put = ToProto(call, input, {}, start.mutable_start()); !put.ok()) return put;
  std::optional<MillLayout> layout;
  const absl::Status status = StreamOver(
      replicas_, DeadlineOf(options_, input), call, kMilling,
      &v1::Milling::Stub::PrepareAsyncLayOutSteps,
      [&](auto& stream) { return WriteInput(stream, start, input); },
      [&](auto& stream) {
        return ReadEach<v1::MillLayout>(stream, [&](const v1::MillLayout& response) {
          absl::StatusOr<MillLayout> taken = FromProto(response);
          if (taken.ok()) layout = *std::move(taken);
          return taken.status();
        });
      });
  if (!status.ok()) return status;
  if (!layout) return BadAnswer(kMilling, Malformed("layout", "is missing"));
  return *std::move(layout);
}

absl::StatusOr<std::vector<MilledStep>> RemoteMilling::Mill(const StageCall& call,
                                                            const MillInput& input,
                                                            StepRange range) const {
  v1::MillRequest start;
  if (absl::Status put = ToProto(call, input, range, start.mutable_start()); !put.ok()) return put;
  std::vector<MilledStep> steps;
  const absl::Status status = StreamOver(
      replicas_, DeadlineOf(options_, input), call, kMilling,
      &v1::Milling::Stub::PrepareAsyncMillSteps,
      [&](auto& stream) { return WriteInput(stream, start, input); },
      [&](auto& stream) {
        steps.clear();
        return ReadEach<v1::MilledStep>(
            stream, [&](const v1::MilledStep& step) { return Append(FromProto(step), &steps); });
      });
  if (!status.ok()) return status;
  if (std::ssize(steps) != range.size())
    return BadAnswer(kMilling, Malformed("step", "not one for each of the range"));
  return steps;
}

absl::StatusOr<MilledProgram> RemoteMilling::Assemble(const StageCall& call, const MillInput& input,
                                                      std::vector<MilledStep> steps,
                                                      std::string_view settings_text) const {
  v1::MillRequest start;
  if (absl::Status put = ToProto(call, input, {}, start.mutable_start()); !put.ok()) return put;
  start.mutable_start()->set_step_count(static_cast<int32_t>(steps.size()));
  start.mutable_start()->set_settings_text(std::string(settings_text));
  MilledProgram program;
  bool summed = false;
  const auto write = [&](auto& stream) {
    absl::Status put = WriteInput(stream, start, input);
    if (!put.ok()) return put;
    return WriteEach<v1::MillRequest>(stream, steps,
                                      [](const MilledStep& step, v1::MillRequest* request) {
                                        return ToProto(step, request->mutable_step());
                                      });
  };
  const auto take = [&](const v1::MillProgramPart& part) -> absl::Status {
    if (!part.has_summary()) {
      program.text += part.text();
      return std::ssize(program.text) <= limits::kMaxProgramBytes
                 ? absl::OkStatus()
                 : Malformed("text", "is longer than a program may be");
    }
    absl::StatusOr<MillReport> report = FromProto(part.summary());
    if (!report.ok()) return report.status();
    program.report = *std::move(report);
    summed = true;
    return absl::OkStatus();
  };
  const absl::Status status =
      StreamOver(replicas_, DeadlineOf(options_, input), call, kMilling,
                 &v1::Milling::Stub::PrepareAsyncAssembleProgram, write, [&](auto& stream) {
                   program = {};
                   summed = false;
                   return ReadEach<v1::MillProgramPart>(stream, take);
                 });
  if (!status.ok()) return status;
  if (!summed) return BadAnswer(kMilling, Malformed("summary", "is missing"));
  return program;
}

}  // namespace slicefarm::coordinator
