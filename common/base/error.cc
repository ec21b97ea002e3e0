#include "common/base/error.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "absl/strings/cord.h"

namespace slicefarm {
namespace {

constexpr absl::string_view kPayload = "slicefarm/detail";

constexpr std::array kNames = std::to_array<std::pair<Reason, std::string_view>>({
    {Reason::kMeshFormatUnknown, "MESH_FORMAT_UNKNOWN"},
    {Reason::kMeshTruncated, "MESH_TRUNCATED"},
    {Reason::kMeshMalformed, "MESH_MALFORMED"},
    {Reason::kMeshNotFinite, "MESH_NOT_FINITE"},
    {Reason::kMeshEmpty, "MESH_EMPTY"},
    {Reason::kMeshTooLarge, "MESH_TOO_LARGE"},
    {Reason::kMeshTooExpensive, "MESH_TOO_EXPENSIVE"},
    {Reason::kMeshReaderCrashed, "MESH_READER_CRASHED"},
    {Reason::kOutOfRange, "OUT_OF_RANGE"},
    {Reason::kOutOfBuildVolume, "OUT_OF_BUILD_VOLUME"},
    {Reason::kNothingToPrint, "NOTHING_TO_PRINT"},
    {Reason::kObjectsCollide, "OBJECTS_COLLIDE"},
    {Reason::kPathsConflict, "PATHS_CONFLICT"},
    {Reason::kSettingUnknown, "SETTING_UNKNOWN"},
    {Reason::kSettingMalformed, "SETTING_MALFORMED"},
    {Reason::kSettingOutOfRange, "SETTING_OUT_OF_RANGE"},
    {Reason::kSettingMisplaced, "SETTING_MISPLACED"},
    {Reason::kSettingOfOtherProcess, "SETTING_OF_OTHER_PROCESS"},
    {Reason::kNotSupported, "NOT_SUPPORTED"},
    {Reason::kPrinterMissing, "PRINTER_MISSING"},
    {Reason::kProcessUnavailable, "PROCESS_UNAVAILABLE"},
    {Reason::kRequestMalformed, "REQUEST_MALFORMED"},
    {Reason::kRequestIdReused, "REQUEST_ID_REUSED"},
    {Reason::kRequestTooLarge, "REQUEST_TOO_LARGE"},
    {Reason::kWebhookRefused, "WEBHOOK_REFUSED"},
    {Reason::kUnauthenticated, "UNAUTHENTICATED"},
    {Reason::kPermissionDenied, "PERMISSION_DENIED"},
    {Reason::kJobNotFound, "JOB_NOT_FOUND"},
    {Reason::kJobNotFinished, "JOB_NOT_FINISHED"},
    {Reason::kBlobNotFound, "BLOB_NOT_FOUND"},
    {Reason::kBlobDigestMismatch, "BLOB_DIGEST_MISMATCH"},
    {Reason::kUploadOffset, "UPLOAD_OFFSET"},
    {Reason::kQueueFull, "QUEUE_FULL"},
    {Reason::kProfileNotFound, "PROFILE_NOT_FOUND"},
    {Reason::kCancelled, "CANCELLED"},
    {Reason::kDeadlineExceeded, "DEADLINE_EXCEEDED"},
    {Reason::kUnavailable, "UNAVAILABLE"},
    {Reason::kMeshReaderKilled, "MESH_READER_KILLED"},
    {Reason::kOverloaded, "OVERLOADED"},
    {Reason::kBuildMismatch, "BUILD_MISMATCH"},
    {Reason::kSharedMissing, "SHARED_MISSING"},
    {Reason::kRangePoisoned, "RANGE_POISONED"},
    {Reason::kJobPoisoned, "JOB_POISONED"},
    {Reason::kStoreFailed, "STORE_FAILED"},
    {Reason::kDiskFull, "DISK_FULL"},
    {Reason::kDiskLow, "DISK_LOW"},
    {Reason::kInternal, "INTERNAL"},
});

Reason DefaultReason(absl::StatusCode code) {
  switch (code) {
    case absl::StatusCode::kCancelled:
      return Reason::kCancelled;
    case absl::StatusCode::kDeadlineExceeded:
      return Reason::kDeadlineExceeded;
    case absl::StatusCode::kUnavailable:
      return Reason::kUnavailable;
    case absl::StatusCode::kInvalidArgument:
      return Reason::kRequestMalformed;
    case absl::StatusCode::kUnauthenticated:
      return Reason::kUnauthenticated;
    case absl::StatusCode::kPermissionDenied:
      return Reason::kPermissionDenied;
    case absl::StatusCode::kOutOfRange:
      return Reason::kOutOfRange;
    default:
      return Reason::kInternal;
  }
}

/// Encodes the detail as NUL-separated texts: reason, key, value, key, value, ... A NUL within a
/// text becomes a space.
std::string Encode(const ErrorDetail& detail) {
  std::string text(ReasonName(detail.reason));
  const auto add = [&text](std::string part) {
    std::replace(part.begin(), part.end(), '\0', ' ');
    (text += '\0') += part;
  };
  for (const auto& [key, value] : detail.metadata) {
    add(key);
    add(value);
  }
  return text;
}

ErrorDetail Decode(const std::string& text) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find('\0', begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  ErrorDetail detail{ReasonFromName(parts[0]).value_or(Reason::kInternal), {}};
  for (size_t i = 1; i + 1 < parts.size(); i += 2) detail.metadata[parts[i]] = parts[i + 1];
  return detail;
}

}  // namespace

std::string_view ReasonName(Reason reason) {
  for (const auto& [value, name] : kNames)
    if (value == reason) return name;
  return "INTERNAL";
}

std::optional<Reason> ReasonFromName(std::string_view name) {
  for (const auto& [value, known] : kNames)
    if (known == name) return value;
  return std::nullopt;
}

absl::Status MakeError(absl::StatusCode code, Reason reason, std::string_view message,
                       std::map<std::string, std::string> metadata) {
  absl::Status status(code, absl::string_view(message.data(), message.size()));
  status.SetPayload(kPayload, absl::Cord(Encode({reason, std::move(metadata)})));
  return status;
}

absl::Status LimitError(Reason reason, std::string_view what, int64_t limit, int64_t got) {
  return MakeError(absl::StatusCode::kInvalidArgument, reason,
                   fmt::format("{}: {}, at most {} are accepted", what, got, limit),
                   {{"limit", std::to_string(limit)}, {"got", std::to_string(got)}});
}

ErrorDetail DetailOf(const absl::Status& status) {
  const absl::optional<absl::Cord> payload = status.GetPayload(kPayload);
  if (payload.has_value()) return Decode(std::string(*payload));
  return {DefaultReason(status.code()), {}};
}

}  // namespace slicefarm
