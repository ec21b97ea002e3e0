#pragma once

#include <grpcpp/support/status.h>

#include "absl/status/status.h"

namespace slicefarm::rpc {

/// ErrorInfo.domain of all our errors.
inline constexpr char kErrorDomain[] = "slicefarm";

/// Metadata that says after how many milliseconds to try again; travels as google.rpc.RetryInfo.
inline constexpr char kRetryAfterMs[] = "retry_after_ms";

/// Metadata of an error that gRPC itself made: the connection broke in the middle of the call. Not
/// there if none could be made.
inline constexpr char kConnectionBroke[] = "connection_broke";

/// An error with its reason and metadata, as google.rpc.Status with ErrorInfo in
/// `grpc-status-details-bin`; equal errors give equal bytes. Long texts are cut, so that the
/// trailers stay within what HTTP/2 peers accept.
grpc::Status ToGrpc(const absl::Status& status);

/// The way back. Errors that gRPC itself made have no details: messages beyond the limit become
/// InvalidArgument with reason REQUEST_TOO_LARGE, a server without a free thread OVERLOADED,
/// connections that broke Unavailable, the rest what their code says.
absl::Status FromGrpc(const grpc::Status& status);

}  // namespace slicefarm::rpc
