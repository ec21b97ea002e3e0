#include "services/coordinator/remote/remote_milling.h"

#include <optional>
#include <string>
#include <utility>

#include "common/model/limits.h"
#include "common/wire/milling/mill_input_wire.h"
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

template <typename Stream>
absl::Status WriteStart(Stream& stream, const MillStart& start) {
  v1::MillRequest request;
  absl::Status status = ToProto(start, request.mutable_start());
  if (status.ok()) stream.Write(request);  // that the peer is gone says the call
  return status;
}

}  // namespace

absl::StatusOr<MillLayout> RemoteMilling::LayOut(const StageCall& call,
                                                 const Shared<MillInput>& input) const {
  const absl::StatusOr<SharedParts> parts = OnePart(input);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::optional<MillLayout> layout;
  const absl::Status status = StreamOver(
      replicas, DeadlineOf(options_, *input), call, kMilling,
      &v1::Milling::Stub::PrepareAsyncLayOutSteps,
      [&](auto& stream) {
        return WriteStart(stream, {call, parts->front()->digest});
      },
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
                                                            const Shared<MillInput>& input,
                                                            StepRange range) const {
  const absl::StatusOr<SharedParts> parts = OnePart(input);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  std::vector<MilledStep> steps;
  const absl::Status status = StreamOver(
      replicas, DeadlineOf(options_, *input), call, kMilling,
      &v1::Milling::Stub::PrepareAsyncMillSteps,
      [&](auto& stream) {
        return WriteStart(stream, {call, parts->front()->digest, range});
      },
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

absl::StatusOr<MilledProgram> RemoteMilling::Assemble(const StageCall& call,
                                                      const Shared<MillInput>& input,
                                                      std::vector<MilledStep> steps,
                                                      std::string_view settings_text) const {
  const absl::StatusOr<SharedParts> parts = OnePart(input);
  if (!parts.ok()) return parts.status();
  SharingReplicas replicas(replicas_, sends_, call, *parts);
  const MillStart start{call,
                        parts->front()->digest,
                        {},
                        static_cast<int32_t>(steps.size()),
                        std::string(settings_text)};
  MilledProgram program;
  bool summed = false;
  const auto write = [&](auto& stream) {
    absl::Status put = WriteStart(stream, start);
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
      StreamOver(replicas, DeadlineOf(options_, *input), call, kMilling,
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
