#include "services/cli/console/exit_code.h"

#include "common/base/error.h"

namespace slicefarm::cli {

ExitCode ExitCodeOf(const absl::Status& status) {
  if (status.ok()) return ExitCode::kOk;
  // A different service listens there.
  if (absl::IsUnimplemented(status)) return ExitCode::kServerUnavailable;
  switch (DetailOf(status).reason) {
    case Reason::kSettingUnknown:
    case Reason::kSettingMalformed:
    case Reason::kSettingOutOfRange:
    case Reason::kSettingMisplaced:
    case Reason::kSettingOfOtherProcess:
    case Reason::kNotSupported:
    case Reason::kPrinterMissing:
    case Reason::kProcessUnavailable:
      return ExitCode::kBadSettings;
    case Reason::kMeshFormatUnknown:
    case Reason::kMeshTruncated:
    case Reason::kMeshMalformed:
    case Reason::kMeshNotFinite:
    case Reason::kMeshEmpty:
    case Reason::kMeshTooLarge:
    case Reason::kMeshTooExpensive:
    case Reason::kMeshReaderCrashed:
    case Reason::kOutOfRange:
    case Reason::kOutOfBuildVolume:
    case Reason::kNothingToPrint:
    case Reason::kObjectsCollide:
    case Reason::kPathsConflict:
      return ExitCode::kBadMesh;
    case Reason::kUnavailable:
    case Reason::kMeshReaderKilled:
    case Reason::kDeadlineExceeded:
      return ExitCode::kServerUnavailable;
    case Reason::kOverloaded:
    case Reason::kQueueFull:
    case Reason::kDiskLow:
      return ExitCode::kRefusedNow;
    case Reason::kStoreFailed:
      return absl::IsUnavailable(status) ? ExitCode::kServerUnavailable : ExitCode::kJobFailed;
    case Reason::kBlobDigestMismatch:  // also DATA_LOSS, but the data are on the server
    case Reason::kRangePoisoned:
    case Reason::kJobPoisoned:
    case Reason::kDiskFull:
      return ExitCode::kJobFailed;
    case Reason::kCancelled:
      return ExitCode::kCancelled;
    case Reason::kJobNotFound:
    case Reason::kJobNotFinished:
    case Reason::kBlobNotFound:
    case Reason::kProfileNotFound:
      return ExitCode::kNotFound;
    case Reason::kRequestMalformed:
    case Reason::kRequestTooLarge:
    case Reason::kRequestIdReused:
    case Reason::kWebhookRefused:
    case Reason::kUnauthenticated:
    case Reason::kPermissionDenied:
      return ExitCode::kUsage;
    default:
      // A failed write is DataLoss (files.h).
      return absl::IsDataLoss(status) ? ExitCode::kOutputFailed : ExitCode::kInternal;
  }
}

}  // namespace slicefarm::cli
