#pragma once

#include "common/rpc/json_log.h"

namespace slicefarm::rpc {

/// From now on gRPC's own lines, of all of the process, are warnings of this log: `grpc FILE`, with
/// what it says as `error`. They tell of certificates that cannot be read again, among others.
void LogGrpcTo(const JsonLog& log);

}  // namespace slicefarm::rpc
