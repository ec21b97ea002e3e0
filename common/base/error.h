#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "absl/status/status.h"

namespace slicefarm {

/// Reason of a refusal or failure. The name of a reason (`MESH_TRUNCATED`) is stable, so clients
/// may test for it. Messages contain it in google.rpc.ErrorInfo.reason.
/// proto/slicefarm/v1/README.md documents each reason.
enum class Reason {
  // Errors in a mesh file.
  kMeshFormatUnknown,
  kMeshTruncated,
  kMeshMalformed,
  kMeshNotFinite,
  kMeshEmpty,
  kMeshTooLarge,
  kMeshTooExpensive,
  kMeshReaderCrashed,
  // Errors in the placement of a mesh.
  kOutOfRange,
  kOutOfBuildVolume,
  kNothingToPrint,
  kObjectsCollide,
  kPathsConflict,
  // Errors in settings and requests.
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
  // Errors of authentication and authorization.
  kUnauthenticated,
  kPermissionDenied,
  // Errors of jobs and blobs.
  kJobNotFound,
  kJobNotFinished,
  kBlobNotFound,
  kBlobDigestMismatch,
  kUploadOffset,
  kQueueFull,
  kProfileNotFound,
  // Errors while a job runs.
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
  // Further errors in settings: a feature that slicefarm lacks, and a job without a printer.
  kNotSupported,
  kPrinterMissing,
};

/// Returns the name of a reason: "MESH_TRUNCATED" for `kMeshTruncated`.
std::string_view ReasonName(Reason reason);
std::optional<Reason> ReasonFromName(std::string_view name);

/// Details of an error besides its message: the reason and facts such as `limit`, `got`, `setting`,
/// `layer`.
struct ErrorDetail {
  Reason reason = Reason::kInternal;
  std::map<std::string, std::string> metadata;
};

/// Returns a status with a reason. The message must describe the problem so that a user can act on
/// it.
absl::Status MakeError(absl::StatusCode code, Reason reason, std::string_view message,
                       std::map<std::string, std::string> metadata = {});

/// Returns an InvalidArgument error for a value above a limit. `what`: name of the counted things,
/// such as "layers", for the message. The metadata has `limit` and `got`, the actual value.
absl::Status LimitError(Reason reason, std::string_view what, int64_t limit, int64_t got);

/// Returns the details that MakeError has attached to `status`. For an error without details,
/// returns the reason that fits the status code.
ErrorDetail DetailOf(const absl::Status& status);

}  // namespace slicefarm
