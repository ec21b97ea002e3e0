#pragma once

#include <grpcpp/impl/rpc_service_method.h>
#include <grpcpp/impl/service_type.h>
#include <grpcpp/support/method_handler.h>

#include <deque>
#include <string>
#include <utility>

#include "common/rpc/server/call_limiter.h"
#include "common/rpc/server/server_stream.h"

namespace slicefarm::rpc {

/// Implementation of the service `Api`, such as v1::Beading. Each method is a function, and each
/// call passes through a CallLimiter, the gate. Methods that are not added are unimplemented. Add
/// methods before the server starts:
///
///   auto service = std::make_unique<LimitedService<v1::Beading>>(gate);
///   service->Add("BeadLayers", &v1::Beading::Service::BeadLayers, [&](Call& call, auto& stream) {
///     ...;
///   });
template <typename Api>
class LimitedService : public grpc::Service {
 public:
  /// REQUIRES: `gate` outlives the service.
  explicit LimitedService(CallLimiter& gate) : gate_(gate) {}

  /// Adds a method with streams in both directions. `method`: method of the generated service; only
  /// its message types are used. `handle`: absl::Status(Call&, ServerStream<Response, Request>&).
  template <typename Response, typename Request, typename Handle>
  void Add(const char* name,
           grpc::Status (Api::Service::*)(grpc::ServerContext*,
                                          grpc::ServerReaderWriter<Response, Request>*),
           Handle handle) {
    const auto serve = [name, handle = std::move(handle)](
                           LimitedService* service, grpc::ServerContext* context,
                           grpc::ServerReaderWriter<Response, Request>* stream) {
      ServerStream<Response, Request> buffered(*stream);
      return service->gate_.Run(*context, name, [&](Call& call) { return handle(call, buffered); });
    };
    AddServed(
        name, grpc::internal::RpcMethod::BIDI_STREAMING,
        new grpc::internal::BidiStreamingHandler<LimitedService, Request, Response>(serve, this));
  }

  /// Adds a method with one request and one response. `handle`: absl::Status(Call&, const Request&,
  /// Response*).
  template <typename Request, typename Response, typename Handle>
  void Add(const char* name,
           grpc::Status (Api::Service::*)(grpc::ServerContext*, const Request*, Response*),
           Handle handle) {
    const auto serve = [name, handle = std::move(handle)](
                           LimitedService* service, grpc::ServerContext* context,
                           const Request* request, Response* response) {
      return service->gate_.Run(*context, name,
                                [&](Call& call) { return handle(call, *request, response); });
    };
    AddServed(name, grpc::internal::RpcMethod::NORMAL_RPC,
              new grpc::internal::RpcMethodHandler<LimitedService, Request, Response>(serve, this));
  }

 private:
  /// Adds a method in the same manner as gRPC's generated services. gRPC owns the method and its
  /// handler.
  void AddServed(const char* name, grpc::internal::RpcMethod::RpcType type,
                 grpc::internal::MethodHandler* handler) {
    paths_.push_back(std::string("/") + Api::service_full_name() + "/" + name);
    AddMethod(new grpc::internal::RpcServiceMethod(paths_.back().c_str(), type, handler));
  }

  CallLimiter& gate_;
  /// Paths of the methods; gRPC's methods contain pointers to them.
  std::deque<std::string> paths_;
};

}  // namespace slicefarm::rpc
