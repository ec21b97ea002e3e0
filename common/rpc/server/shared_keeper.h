#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/byte_budget.h"
#include "common/base/shared/shared_cache.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_gate.h"

namespace slicefarm::rpc {

/// slicefarm.v1.SharedValues: what a server keeps of its jobs' calls, at most
/// limits::kMaxKeptSharedBytes. What comes must be of the digest that it is sent under. There is no
/// way to read it back, and who may call is the server's policy: coordinators.
class SharedKeeper {
 public:
  explicit SharedKeeper(JsonLog log);
  ~SharedKeeper();

  SharedCache& cache() { return cache_; }
  grpc::Service& service() { return *service_; }

 private:
  SharedCache cache_;
  ByteBudget arriving_;
  CallGate gate_;
  std::unique_ptr<grpc::Service> service_;
};

}  // namespace slicefarm::rpc
