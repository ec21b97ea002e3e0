#include "common/rpc/observe/trace_metadata.h"

namespace slicefarm::rpc {

TraceContext TraceOf(const grpc::ServerContextBase& context) {
  const auto& metadata = context.client_metadata();
  if (metadata.count(kTraceparentKey) != 1) return {};  // several values would be ambiguous
  const grpc::string_ref value = metadata.find(kTraceparentKey)->second;
  return ParseTraceparent({value.data(), value.size()}).value_or(TraceContext());
}

void SetTrace(const TraceContext& trace, grpc::ClientContext* context) {
  if (!trace.empty()) context->AddMetadata(kTraceparentKey, Traceparent(trace));
}

}  // namespace slicefarm::rpc
