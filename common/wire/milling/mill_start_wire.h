#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/model/limits.h"
#include "common/stage/stages.h"
#include "common/wire/milling/mill_input_wire.h"
#include "common/wire/milling/milled_wire.h"
#include "common/wire/stage_call_wire.h"
#include "common/wire/support/message_stream.h"
#include "slicefarm/v1/milling.pb.h"

namespace slicefarm {

/// What a call of the milling service says, as a whole: `start`, meshes, and steps to put together.
struct MillStart {
  StageCall call;
  MillInput input;
  StepRange range;  ///< of MillSteps
  std::vector<MilledStep> steps;
  std::string settings_text;
};

/// The first message, of which the head says what follows. `range`: empty for calls about none.
absl::Status ToProto(const StageCall& call, const MillInput& input, StepRange range,
                     v1::MillStart* proto);

/// All of a call but its meshes and steps.
struct MillStartHead {
  StageCall call;
  MillInputReader input;
  StepRange range;
  int64_t step_count = 0;
  std::string settings_text;
};
absl::StatusOr<MillStartHead> FromProto(const v1::MillStart& proto);

/// Reads all of a call. Errors: REQUEST_MALFORMED and REQUEST_TOO_LARGE with the way to the field;
/// MESH_TOO_LARGE; `cancel`'s.
template <typename Stream>
absl::StatusOr<MillStart> ReadMillStart(Stream& stream, const CancelToken& cancel) {
  auto head = ReadStart<v1::MillRequest>(stream, cancel);
  if (!head.ok()) return head.status();
  std::vector<MilledStep> steps;
  absl::Status read = ReadEach<v1::MillRequest>(stream, [&](const v1::MillRequest& request) {
    if (request.has_piece()) return head->input.Add(request.piece());
    if (std::ssize(steps) == head->step_count) return Malformed("step", "more than were announced");
    return Append(FromProto(request.step()), &steps);
  });
  read.Update(cancel.Check());
  if (!read.ok()) return read;
  if (std::ssize(steps) < head->step_count) return Malformed("step", "fewer than were announced");
  absl::StatusOr<MillInput> input = head->input.Finish();
  if (!input.ok()) return input.status();
  return MillStart{std::move(head->call), *std::move(input), head->range, std::move(steps),
                   std::move(head->settings_text)};
}

namespace v1 {
using slicefarm::FromProto;  // so that templates find it by the message's namespace
}  // namespace v1

}  // namespace slicefarm
