#pragma once

#include <grpcpp/support/status.h>

#include "absl/status/status.h"

namespace slicefarm::rpc {

/// ErrorInfo.domain of all errors of slicefarm.
inline constexpr char kErrorDomain[] = "slicefarm";

/// Metadata key for the time in milliseconds after which a retry is useful. The value is sent as
/// google.rpc.RetryInfo.
inline constexpr char kRetryAfterMs[] = "retry_after_ms";

/// Metadata key of an error that gRPC itself made. It is set if the connection broke during the
/// call, and absent if there was no connection at all.
inline constexpr char kConnectionBroke[] = "connection_broke";

/// Returns the gRPC status of an error. Reason and metadata become a google.rpc.Status with
/// ErrorInfo in `grpc-status-details-bin`. Equal errors give equal bytes. Long texts are cut, so
/// that the trailers do not exceed the limits of HTTP/2 peers.
grpc::Status ToGrpc(const absl::Status& status);

/// Converts gRPC's status back to an error. Errors that gRPC itself made have no details, and are
/// converted as follows: messages beyond the size limit become InvalidArgument with reason
/// REQUEST_TOO_LARGE; a server without a free thread becomes OVERLOADED; broken connections become
/// Unavailable. For all other errors, the reason fits the status code (DetailOf).
absl::Status FromGrpc(const grpc::Status& status);

}  // namespace slicefarm::rpc
