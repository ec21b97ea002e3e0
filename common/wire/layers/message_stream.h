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

/// Reading and writing the messages of a call one by one, at either end of it. A Stream has
/// Read(Message*) and Write(const Message&); both tell by false that there is no more.

/// What the first message of a call says; it must hold `start`.
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

/// Begins a call. That the peer is gone shows at what is written next, or at the call's end.
template <typename Request, typename Stream, typename Start>
absl::Status WriteStart(Stream& stream, const Start& start) {
  Request request;
  absl::Status status = ToProto(start, request.mutable_start());
  if (status.ok()) stream.Write(request);
  return status;
}

/// Gives each message that is left to `take`, until one is refused; the error says which.
template <typename Message, typename Stream, typename Take>
absl::Status ReadEach(Stream& stream, const Take& take) {
  Message message;
  for (size_t i = 0; stream.Read(&message); ++i) {
    if (absl::Status status = take(message); !status.ok()) return Within("message", i, status);
  }
  return absl::OkStatus();
}

/// Writes a message for each of `models`, filled by `fill(model, &message)`. Unavailable if the
/// peer takes no more.
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

/// Appends a converted message, or hands on why it could not be converted.
template <typename Model>
absl::Status Append(absl::StatusOr<Model> model, std::vector<Model>* models) {
  if (!model.ok()) return model.status();
  models->push_back(*std::move(model));
  return absl::OkStatus();
}

/// The layers that are left to read of a call that `start` began: those of its range and halo.
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
