#include "common/rpc/status_mapping.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/rpc/utf8.h"
#include "google/rpc/error_details.pb.h"
#include "google/rpc/status.pb.h"

namespace slicefarm::rpc {
namespace {

constexpr size_t kMaxMessageBytes = 1024;
constexpr int64_t kMaxRetryAfterS = 24 * 3600;
constexpr size_t kMaxValueBytes = 256;
constexpr size_t kMaxValues = 8;

std::string MessageOf(const absl::Status& status) {
  return ToUtf8({status.message().data(), status.message().size()}, kMaxMessageBytes);
}

int64_t ToInt(const std::string& text) {
  int64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Serializes a message so that equal errors give equal bytes. By default, protobuf writes the
/// entries of a map in any order.
template <typename Message>
void Pack(const Message& message, google::protobuf::Any* any) {
  any->PackFrom(message);
  std::string bytes;
  {
    google::protobuf::io::StringOutputStream stream(&bytes);
    google::protobuf::io::CodedOutputStream coded(&stream);
    coded.SetSerializationDeterministic(true);
    message.SerializeToCodedStream(&coded);
  }
  any->set_value(bytes);
}

google::rpc::RetryInfo RetryAfter(int64_t ms) {
  google::rpc::RetryInfo info;
  info.mutable_retry_delay()->set_seconds(ms / 1000);
  info.mutable_retry_delay()->set_nanos(static_cast<int32_t>(ms % 1000) * 1'000'000);
  return info;
}

/// Returns the value of the first of these keys that exists, with the prefix that belongs to the
/// key.
std::string Named(const std::map<std::string, std::string>& metadata,
                  std::initializer_list<std::pair<const char*, const char*>> keys) {
  for (const auto& [key, name] : keys) {
    const auto found = metadata.find(key);
    if (found != metadata.end()) return ToUtf8(name + found->second, kMaxValueBytes);
  }
  return "";
}

google::rpc::BadRequest BadRequestOf(const std::string& field, const std::string& description) {
  google::rpc::BadRequest bad;
  google::rpc::BadRequest::FieldViolation& violation = *bad.add_field_violations();
  violation.set_field(field);
  violation.set_description(description);
  return bad;
}

/// Returns a QuotaFailure or a PreconditionFailure with one violation, which the caller completes.
template <typename Failure>
Failure FailureOf(const std::string& subject, const std::string& description) {
  Failure failure;
  failure.add_violations()->set_subject(subject);
  failure.mutable_violations(0)->set_description(description);
  return failure;
}

/// Adds the standard detail of errors with this code (AIP-193), which client libraries support. It
/// is made from the contents of ErrorInfo.
void AddDetailOfCode(const ErrorDetail& detail, google::rpc::Status* proto) {
  const std::string description = ToUtf8(proto->message(), kMaxValueBytes);
  const std::string reason(ReasonName(detail.reason));
  switch (static_cast<absl::StatusCode>(proto->code())) {
    case absl::StatusCode::kInvalidArgument: {
      const std::string field = Named(detail.metadata, {{"field", ""}, {"setting", "settings."}});
      if (!field.empty()) Pack(BadRequestOf(field, description), proto->add_details());
      return;
    }
    case absl::StatusCode::kResourceExhausted:
      Pack(FailureOf<google::rpc::QuotaFailure>(reason, description), proto->add_details());
      return;
    case absl::StatusCode::kFailedPrecondition: {
      auto failure = FailureOf<google::rpc::PreconditionFailure>(
          Named(detail.metadata,
                {{"sha256", "blobs/"}, {"job", "jobs/"}, {"profile", "profiles/"}}),
          description);
      failure.mutable_violations(0)->set_type(reason);
      Pack(failure, proto->add_details());
      return;
    }
    default:
      return;
  }
}

google::rpc::Status Details(const absl::Status& status) {
  ErrorDetail detail = DetailOf(status);
  google::rpc::Status proto;
  proto.set_code(static_cast<int>(status.code()));
  proto.set_message(MessageOf(status));
  if (const auto retry = detail.metadata.find(kRetryAfterMs); retry != detail.metadata.end()) {
    Pack(RetryAfter(ToInt(retry->second)), proto.add_details());
    detail.metadata.erase(retry);
  }
  AddDetailOfCode(detail, &proto);
  google::rpc::ErrorInfo info;
  info.set_domain(kErrorDomain);
  info.set_reason(std::string(ReasonName(detail.reason)));
  for (const auto& [key, value] : detail.metadata) {
    if (info.metadata_size() == kMaxValues) break;
    (*info.mutable_metadata())[ToUtf8(key, kMaxValueBytes)] = ToUtf8(value, kMaxValueBytes);
  }
  Pack(info, proto.add_details());
  return proto;
}

bool Contains(const std::string& text, std::initializer_list<std::string_view> parts) {
  for (const std::string_view part : parts) {
    if (text.find(part) != std::string::npos) return true;
  }
  return false;
}

/// Returns true for gRPC's errors of a connection that broke during the call. If no connection can
/// be made, gRPC reports the same texts about earlier connections, with additional words; these
/// errors do not count.
bool IsBrokenConnection(const grpc::Status& status) {
  const grpc::StatusCode code = status.error_code();
  const std::string& message = status.error_message();
  return (code == grpc::StatusCode::UNKNOWN || code == grpc::StatusCode::INTERNAL ||
          code == grpc::StatusCode::UNAVAILABLE) &&
         Contains(message, {"RST_STREAM", "Stream removed", "Socket closed", "Connection reset",
                            "Connection timed out", "Broken pipe", "keepalive", "ping timeout"}) &&
         !Contains(message, {"ailed to connect", "last error"});
}

absl::Status FromLibrary(const grpc::Status& status) {
  const auto code = static_cast<absl::StatusCode>(status.error_code());
  const std::string& message = status.error_message();
  if (code == absl::StatusCode::kResourceExhausted && Contains(message, {"larger than max"})) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestTooLarge, message);
  }
  if (code == absl::StatusCode::kResourceExhausted && Contains(message, {"hreadpool Exhausted"})) {
    return MakeError(code, Reason::kOverloaded, message);
  }
  if (IsBrokenConnection(status)) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable, message,
                     {{kConnectionBroke, "true"}});
  }
  const bool unknown = code == absl::StatusCode::kUnimplemented && message.empty();
  return MakeError(code, DetailOf(absl::Status(code, message)).reason,
                   unknown ? "the server has no such method" : message);
}

}  // namespace

grpc::Status ToGrpc(const absl::Status& status) {
  if (status.ok()) return grpc::Status::OK;
  return grpc::Status(static_cast<grpc::StatusCode>(status.code()), MessageOf(status),
                      Details(status).SerializeAsString());
}

absl::Status FromGrpc(const grpc::Status& status) {
  if (status.ok()) return absl::OkStatus();
  google::rpc::Status proto;
  if (status.error_details().empty() || !proto.ParseFromString(status.error_details())) {
    return FromLibrary(status);
  }
  Reason reason = Reason::kInternal;
  std::map<std::string, std::string> metadata;
  for (const google::protobuf::Any& any : proto.details()) {
    google::rpc::ErrorInfo info;
    google::rpc::RetryInfo retry;
    if (any.UnpackTo(&info)) {
      reason = ReasonFromName(info.reason()).value_or(Reason::kInternal);
      metadata.insert(info.metadata().begin(), info.metadata().end());
    } else if (any.UnpackTo(&retry)) {
      const auto& delay = retry.retry_delay();
      const int64_t seconds = std::clamp<int64_t>(delay.seconds(), 0, kMaxRetryAfterS);
      metadata[kRetryAfterMs] = std::to_string(seconds * 1000 + delay.nanos() / 1'000'000);
    }
  }
  return MakeError(static_cast<absl::StatusCode>(status.error_code()), reason,
                   status.error_message(), std::move(metadata));
}

}  // namespace slicefarm::rpc
