#pragma once

#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// From now on what gRPC and Protobuf say by themselves, in all of the process, are warnings of
/// this log: `grpc FILE` and `protobuf FILE`, with their words as `error`. gRPC tells of
/// certificates that cannot be read again, among others; Protobuf of texts that are no UTF-8, which
/// any caller can send.
void LogLibrariesTo(const JsonLog& log);

}  // namespace slicefarm::rpc
