#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "absl/status/statusor.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/shared/shared.h"
#include "common/base/shared/shared_bytes.h"
#include "common/base/shared/shared_cache.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {

// Data that all calls of a job share is sent to a server only once. Calls refer to it by its
// digest:
//
//   template <> struct MessageOf<Table> { using Type = v1::Table; };   // with ToProto and
//   FromProto
//
//   const auto part = PartOf(shared);                 // in the client: made once per value
//   start.set_table((*part)->digest);                 // and pass the part to SharedSends
//
//   auto table = TakeShared<Table>(cache, start.table(), "table");     // in the server
//
// The server also parses the bytes only once, and passes the same Shared<Table> to each call.

/// Message type for a shared value of type T. REQUIRES: `absl::Status ToProto(const T&, Type*)` and
/// `absl::StatusOr<T> FromProto(const Type&)`.
template <typename T>
struct MessageOf;

namespace internal {

/// Serializes a value and computes its digest.
template <typename T>
absl::StatusOr<std::shared_ptr<const SharedBytes>> MakePart(const T& value) {
  typename MessageOf<T>::Type message;
  if (absl::Status status = ToProto(value, &message); !status.ok()) return status;
  const auto size = static_cast<int64_t>(message.ByteSizeLong());
  if (size > limits::kMaxSharedBytes)
    return LimitError(Reason::kRequestTooLarge, "bytes that the calls of a job have in common",
                      limits::kMaxSharedBytes, size);
  SharedBytes part{std::string(message.GetTypeName()), {}, message.SerializeAsString()};
  part.digest = SharedDigest(part.kind, part.bytes);
  return std::make_shared<const SharedBytes>(std::move(part));
}

}  // namespace internal

/// Returns the serialized value with its digest. Errors: the error of ToProto; REQUEST_TOO_LARGE
/// for more than limits::kMaxSharedBytes. Cost: O(bytes) at the first call for a value; later calls
/// are free.
template <typename T>
const absl::StatusOr<std::shared_ptr<const SharedBytes>>& PartOf(const Shared<T>& value) {
  return value.Once([](const T& held) { return internal::MakePart(held); });
}

/// Returns the list of shared parts for a call that refers only to this value.
template <typename T>
absl::StatusOr<SharedParts> OnePart(const Shared<T>& value) {
  const auto& part = PartOf(value);
  if (!part.ok()) return part.status();
  return SharedParts{*part};
}

/// Returns the value with this digest from the cache. `field`: field of the message that contains
/// the digest, for error messages. Errors: SHARED_MISSING if the cache does not have the value;
/// REQUEST_MALFORMED and REQUEST_TOO_LARGE with the path to the field.
template <typename T>
absl::StatusOr<Shared<T>> TakeShared(SharedCache& cache, const std::string& digest,
                                     std::string_view field) {
  using Message = typename MessageOf<T>::Type;
  if (!IsSha256Hex(digest)) return Malformed(field, "is no digest");
  auto value = cache.Take<T>(
      digest, Message::descriptor()->full_name(), [](std::string_view bytes) -> absl::StatusOr<T> {
        Message message;
        if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
          return Malformed("bytes", "are not such a message");
        return FromProto(std::move(message));
      });
  if (!value.ok() && MissingDigest(value.status()).empty()) return Within(field, value.status());
  return value;
}

}  // namespace slicefarm
