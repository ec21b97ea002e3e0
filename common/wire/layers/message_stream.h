#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "common/base/error.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

// Functions for reading and writing the messages of a call one by one, in the client and the
// server. A Stream has Read(Message*) and Write(const Message&). Read returns false if there are
// no more messages, Write if the call has ended.

/// Reads the first message of a call. `cancel`: token that is stored in the result's StageCall.
/// Errors: REQUEST_MALFORMED if there is no message, or if it lacks the field `start`; any error of
/// FromProto for the start.
template <typename Request, typename Stream>
auto ReadStart(Stream& stream, const CancelToken& cancel)
    -> decltype(FromProto(std::declval<Request>().start())) {
  Request first;
  if (!stream.Read(&first) || !first.has_start()) return Malformed("start", "does not come first");
  auto start = FromProto(first.start());
  if (!start.ok()) return Within("start", start.status());
  start->call.cancel = cancel;
  return start;
}

/// Writes the first message of a call. If the peer has disconnected, this function still returns
/// OK: the next write fails.
template <typename Request, typename Stream, typename Start>
absl::Status WriteStart(Stream& stream, const Start& start) {
  Request request;
  absl::Status status = ToProto(start, request.mutable_start());
  if (status.ok()) stream.Write(request);
  return status;
}

/// Passes each remaining message to `take` until `take` returns an error. Returns this error, with
/// the number of the message.
template <typename Message, typename Stream, typename Take>
absl::Status ReadEach(Stream& stream, const Take& take) {
  Message message;
  for (size_t i = 0; stream.Read(&message); ++i) {
    if (absl::Status status = take(message); !status.ok()) return Within("message", i, status);
  }
  return absl::OkStatus();
}

/// Writes a message for each of `models`. `fill(model, &message)` fills the message. Errors: the
/// error of `fill`; Unavailable if the peer has stopped reading.
template <typename Message, typename Stream, typename Models, typename Fill>
absl::Status WriteEach(Stream& stream, Models&& models, const Fill& fill) {
  for (auto& model : models) {
    Message message;
    if (absl::Status status = fill(model, &message); !status.ok()) return status;
    if (!stream.Write(message)) {
      return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, "the peer went away");
    }
  }
  return absl::OkStatus();
}

/// Appends the result of a conversion to `models`, or returns its error.
template <typename Model>
absl::Status Append(absl::StatusOr<Model> model, std::vector<Model>* models) {
  if (!model.ok()) return model.status();
  models->push_back(*std::move(model));
  return absl::OkStatus();
}

/// Reads the layers that follow the first message of a call: the layers of start.range and their
/// halo.
template <typename Request, typename Start, typename Stream>
absl::StatusOr<std::vector<SlicedLayer>> ReadNeighbourhood(Stream& stream, const Start& start) {
  std::vector<SlicedLayer> layers;
  absl::Status status = ReadEach<Request>(stream, [&](const Request& request) {
    return AppendNext(FromProto(request.layer()), &layers);
  });
  status.Update(start.call.cancel.Check());
  status.Update(CheckNeighbourhood(layers, start.range));
  if (!status.ok()) return status;
  return layers;
}

}  // namespace slicefarm
