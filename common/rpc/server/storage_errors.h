#pragma once

#include <grpcpp/support/server_interceptor.h>

#include <utility>

#include "common/rpc/observe/json_log.h"

namespace slicefarm::rpc {

/// Keeps to the server what its storage says: names of files, hosts and tables are no business of
/// its clients. Errors of STORE_FAILED and DISK_FULL go to the log whole, and to the client with
/// their code and reason and a message of this file. DATA_LOSS passes: it is about what the client
/// has sent, and names that.
class StorageErrorsFactory : public grpc::experimental::ServerInterceptorFactoryInterface {
 public:
  explicit StorageErrorsFactory(JsonLog log) : log_(std::move(log)) {}

  grpc::experimental::Interceptor* CreateServerInterceptor(
      grpc::experimental::ServerRpcInfo* info) override;

 private:
  const JsonLog log_;
};

}  // namespace slicefarm::rpc
