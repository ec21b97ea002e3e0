#pragma once

#include <chrono>
#include <concepts>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "absl/status/status.h"
#include "common/base/build_info.h"
#include "common/base/cancel_token.h"
#include "google/protobuf/io/coded_stream.h"
#include "google/protobuf/io/zero_copy_stream_impl_lite.h"
#include "google/protobuf/repeated_field.h"

namespace slicefarm::fuzz {

/// Stream of the request messages of a call, with the interface that a stage's service reads from.
template <typename Request>
class Requests {
 public:
  explicit Requests(google::protobuf::RepeatedPtrField<Request> requests)
      : requests_(std::move(requests)) {
    for (Request& request : requests_) {
      if (request.has_start()) Welcome(*request.mutable_start()->mutable_call());
    }
  }

  bool Read(Request* request) {
    if (next_ == requests_.size()) return false;
    *request = std::move(requests_[next_++]);
    return true;
  }

 private:
  /// Replaces an empty build id by this build's id.
  template <typename Call>
  static void Welcome(Call& call) {
    if (call.build_id().empty()) call.set_build_id(std::string(BuildId()));
  }

  google::protobuf::RepeatedPtrField<Request> requests_;
  int next_ = 0;
};

/// Returns a token that is cancelled after a deadline, as in a service.
inline CancelToken WithDeadline(
    std::chrono::milliseconds deadline = std::chrono::milliseconds(1000)) {
  const auto end = std::chrono::steady_clock::now() + deadline;
  return CancelToken([end] { return std::chrono::steady_clock::now() > end; });
}

/// Returns the model as a message, with the form of ToProto that the model's type has.
template <typename Proto, typename Model>
Proto Encoded(const Model& model) {
  Proto proto;
  if constexpr (requires {
                  { ToProto(model) } -> std::same_as<Proto>;
                }) {
    proto = ToProto(model);
  } else if constexpr (requires {
                         { ToProto(model, &proto) } -> std::same_as<absl::Status>;
                       }) {
    if (!ToProto(model, &proto).ok()) std::abort();  // a model from the wire must convert back
  } else {
    ToProto(model, &proto);
  }
  return proto;
}

/// Serializes a message so that equal messages have equal bytes, even with maps.
template <typename Proto>
std::string Serialized(const Proto& proto) {
  std::string bytes;
  {
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::io::CodedOutputStream coded(&stream);
    coded.SetSerializationDeterministic(true);
    proto.SerializeToCodedStream(&coded);
  }
  return bytes;
}

/// Checks that a message that FromProto accepts is converted to a model and back without loss.
/// Aborts if not.
template <typename Proto>
void CheckRoundTrip(const Proto& proto) {
  const auto model = FromProto(proto);
  if (!model.ok()) return;
  const Proto encoded = Encoded<Proto>(*model);
  const auto again = FromProto(encoded);
  if (!again.ok()) std::abort();
  if constexpr (requires { *again == *model; }) {
    if (!(*again == *model)) std::abort();
  }
  if (Serialized(Encoded<Proto>(*again)) != Serialized(encoded)) std::abort();
}

/// Checks for numbers that no printer can read.
inline void CheckGcode(std::string_view gcode) {
  for (size_t begin = 0; begin < gcode.size();) {
    const size_t end = std::min(gcode.find('\n', begin), gcode.size());
    const std::string_view line = gcode.substr(begin, end - begin);
    const bool moves = line.starts_with("G1 ");
    if (moves && line.find_first_of("ni", 3) < line.find(';')) std::abort();  // nan, inf
    begin = end + 1;
  }
}

}  // namespace slicefarm::fuzz
