#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace slicefarm {

/// Why something was refused or failed: stable names that clients may test for. The wire carries
/// the name
/// (`MESH_TRUNCATED`) in google.rpc.ErrorInfo.reason; proto/slicefarm/v1/README.md documents each.
enum class Reason {
  // The mesh, as read.
  kMeshFormatUnknown,
  kMeshTruncated,
  kMeshMalformed,
  kMeshNotFinite,
  kMeshEmpty,
  kMeshTooLarge,
  kMeshTooExpensive,
  kMeshReaderCrashed,
  // The mesh, as placed.
  kOutOfRange,
  kOutOfBuildVolume,
  kNothingToPrint,
  kObjectsCollide,
  kPathsConflict,
  // Settings and requests.
  kSettingUnknown,
  kSettingMalformed,
  kSettingOutOfRange,
  kSettingMisplaced,
  kSettingOfOtherProcess,
  kProcessUnavailable,
  kRequestMalformed,
  kRequestIdReused,
  kRequestTooLarge,
  kWebhookRefused,
  // Who asks.
  kUnauthenticated,
  kPermissionDenied,
  // Jobs and blobs.
  kJobNotFound,
  kJobNotFinished,
  kBlobNotFound,
  kBlobDigestMismatch,
  kUploadOffset,
  kQueueFull,
  kProfileNotFound,
  // Running.
  kCancelled,
  kDeadlineExceeded,
  kUnavailable,
  kMeshReaderKilled,
  kOverloaded,
  kBuildMismatch,
  kSharedMissing,
  kRangePoisoned,
  kJobPoisoned,
  kStoreFailed,
  kDiskFull,
  kDiskLow,
  kInternal,
  // Settings again: a feature that slicefarm lacks, and a job without a printer.
  kNotSupported,
  kPrinterMissing,
};

/// `kMeshTruncated` -> "MESH_TRUNCATED".
std::string_view ReasonName(Reason reason);
std::optional<Reason> ReasonFromName(std::string_view name);

/// What travels with an error besides its message: the reason and facts such as `limit`, `got`,
/// `setting`, `layer`.
struct ErrorDetail {
  Reason reason = Reason::kInternal;
  std::map<std::string, std::string> metadata;
};

/// A status with its reason attached. The message says what is wrong in words a user can act on.
absl::Status MakeError(absl::StatusCode code, Reason reason, std::string_view message,
                       std::map<std::string, std::string> metadata = {});

/// InvalidArgument naming the bound: message, metadata `limit` and `got`.
absl::Status LimitError(Reason reason, std::string_view what, int64_t limit, int64_t got);

/// The detail attached by MakeError; for other errors, a reason that suits the code.
ErrorDetail DetailOf(const absl::Status& status);

}  // namespace slicefarm
