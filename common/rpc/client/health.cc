#include "common/rpc/client/health.h"

#include <grpcpp/generic/generic_stub.h>
#include <grpcpp/support/byte_buffer.h>

#include <vector>

#include "common/base/build_info.h"

namespace slicefarm::rpc {
namespace {

/// Returns a grpc.health.v1.HealthCheckRequest: the service as field 1, or nothing. Debian has no
/// package with stubs for the two messages. REQUIRES: the name is shorter than 128 bytes.
grpc::ByteBuffer RequestFor(const std::string& service) {
  if (service.empty()) return {nullptr, 0};
  const grpc::Slice bytes("\x0a" + std::string(1, static_cast<char>(service.size())) + service);
  return {&bytes, 1};
}

/// Returns true for a grpc.health.v1.HealthCheckResponse with status = SERVING.
bool SaysServing(const grpc::ByteBuffer& response) {
  std::vector<grpc::Slice> slices;
  if (!response.Dump(&slices).ok()) return false;
  std::string bytes;
  for (const grpc::Slice& slice : slices)
    bytes.append(reinterpret_cast<const char*>(slice.begin()), slice.size());
  return bytes == "\x08\x01";
}

}  // namespace

absl::StatusOr<bool> IsServing(const std::shared_ptr<grpc::Channel>& channel,
                               const std::string& service, const ClientCallOptions& options) {
  grpc::GenericStub stub(channel);
  ClientCall call(options);
  const grpc::ByteBuffer request = RequestFor(service);
  const auto reader =
      stub.PrepareUnaryCall(call.context(), "/grpc.health.v1.Health/Check", request, call.queue());
  reader->StartCall();
  grpc::ByteBuffer response;
  grpc::Status status;
  reader->Finish(&response, &status, nullptr);
  call.Await();
  if (absl::Status outcome = call.Outcome(status); !outcome.ok()) return outcome;
  return SaysServing(response);
}

std::string ServiceOfThisBuild() { return "build/" + std::string(BuildId()); }

}  // namespace slicefarm::rpc
