#include "services/coordinator/remote/remote_milling.h"

#include <optional>
#include <string>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/mill_start_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "slicefarm/v1/milling.grpc.pb.h"

namespace slicefarm::coordinator {
namespace {

/// Returns the deadline of a call. The mesh alone does not determine the time, because the steps
/// may be many and fine.
std::chrono::milliseconds DeadlineOf(const RemoteOptions& options, const MillInput& input) {
  constexpr int64_t kPointsATriangle = 100;
  return 4 * options.DeadlineFor(kPointsATriangle * std::ssize(input.part.triangles));
}

struct ProgramAnswer {
  MilledProgram program;
  bool summed = false;
};

absl::Status TakePart(const v1::MillProgramPart& part, ProgramAnswer& answer) {
  std::string& text = answer.program.text;
  if (!part.has_summary()) {
    text += part.text();
    return std::ssize(text) <= limits::kMaxProgramBytes
               ? absl::OkStatus()
               : Malformed("text", "is longer than a program may be");
  }
  absl::StatusOr<MillReport> report = FromProto(part.summary());
  if (!report.ok()) return report.status();
  answer.program.report = *std::move(report);
  answer.summed = true;
  return absl::OkStatus();
}

}  // namespace

absl::StatusOr<MillLayout> RemoteMilling::LayOut(const StageCall& call,
                                                 const Shared<MillInput>& input) const {
  return client_.OnlyOne(client_.AskAbout<std::optional<MillLayout>>(
      input, MillStart{call, {}}, DeadlineOf(client_.options(), *input),
      &v1::Milling::Stub::PrepareAsyncLayOutSteps));
}

absl::StatusOr<std::vector<MilledStep>> RemoteMilling::Mill(const StageCall& call,
                                                            const Shared<MillInput>& input,
                                                            StepRange range) const {
  return client_.Fitting(
      client_.AskAbout<std::vector<MilledStep>>(input, MillStart{call, {}, range},
                                                DeadlineOf(client_.options(), *input),
                                                &v1::Milling::Stub::PrepareAsyncMillSteps),
      [range](const auto& steps) {
        return std::ssize(steps) == range.size()
                   ? absl::OkStatus()
                   : Malformed("step", "not one for each of the range");
      });
}

absl::StatusOr<MilledProgram> RemoteMilling::Assemble(const StageCall& call,
                                                      const Shared<MillInput>& input,
                                                      std::vector<MilledStep> steps,
                                                      std::string_view settings_text) const {
  const MillStart start{
      call, {}, {}, static_cast<int32_t>(steps.size()), std::string(settings_text)};
  const auto write = [&](auto& stream) {
    return WriteEach<v1::MillRequest>(stream, steps,
                                      [](const MilledStep& step, v1::MillRequest* request) {
                                        return ToProto(step, request->mutable_step());
                                      });
  };
  auto answer =
      client_.Fitting(client_.AskAbout<ProgramAnswer>(
                          input, start, DeadlineOf(client_.options(), *input),
                          &v1::Milling::Stub::PrepareAsyncAssembleProgram, write, TakePart),
                      [](const ProgramAnswer& made) {
                        return made.summed ? absl::OkStatus() : Malformed("summary", "is missing");
                      });
  if (!answer.ok()) return answer.status();
  return std::move(answer->program);
}

}  // namespace slicefarm::coordinator
