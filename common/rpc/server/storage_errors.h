#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <utility>

#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// Interceptor factory that hides messages of the storage from clients, because they contain names
/// of files, hosts and tables. For STORE_FAILED and DISK_FULL, the log gets the complete error, and
/// the client gets code and reason with a general message. DATA_LOSS is not changed: it concerns
/// data that the client sent.
class StorageErrorsFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  explicit StorageErrorsFactory(JsonLog log) : log_(std::move(log)) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const JsonLog log_;
};

}  // namespace slicefarm::rpc
