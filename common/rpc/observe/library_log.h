#pragma once

#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// Redirects messages of gRPC and Protobuf in this process to `log`, as warnings `grpc FILE` and
/// `protobuf FILE`, with the text as `error`. For example, gRPC reports renewed certificates that
/// it cannot read, and Protobuf reports texts that are not UTF-8, which any caller can send.
void LogLibrariesTo(const JsonLog& log);

}  // namespace slicefarm::rpc
