#pragma once

#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// Redirects messages of gRPC and Protobuf in this program to `log`. They become warnings with the
/// message `grpc FILE` or `protobuf FILE` and the text in the field `error`. Examples: gRPC reports
/// renewed certificates that it cannot read. Protobuf reports texts that are not UTF-8, which any
/// caller can send.
void LogLibrariesTo(const JsonLog& log);

}  // namespace slicefarm::rpc
