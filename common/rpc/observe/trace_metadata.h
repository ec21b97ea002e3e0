#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/server_context.h>

#include "common/base/trace_context.h"

namespace slicefarm::rpc {

/// Metadata key of the trace of a call, as defined by W3C.
inline constexpr char kTraceparentKey[] = "traceparent";

/// Returns the trace that the client of the call sent; empty if it sent none, or an invalid one.
TraceContext TraceOf(const grpc::ServerContextBase& context);

/// Adds `trace` to the call, unless it is empty. Call it before the call starts.
void SetTrace(const TraceContext& trace, grpc::ClientContext* context);

}  // namespace slicefarm::rpc
