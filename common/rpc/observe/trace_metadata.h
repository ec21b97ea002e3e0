#pragma once

#include <grpcpp/client_context.h>
#include <grpcpp/server_context.h>

#include "common/base/trace_context.h"

namespace slicefarm::rpc {

/// The trace of a call travels in its metadata, under W3C's name for it.
inline constexpr char kTraceparentKey[] = "traceparent";

/// What the client of the call gave; empty if it gave none, or nonsense.
TraceContext TraceOf(const grpc::ServerContextBase& context);

/// Gives `trace` to the call; nothing if it is empty. Before the call starts.
void SetTrace(const TraceContext& trace, grpc::ClientContext* context);

}  // namespace slicefarm::rpc
