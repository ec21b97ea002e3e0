#pragma once

#include <grpcpp/impl/codegen/service_type.h>

#include <memory>

#include "common/base/byte_budget.h"
#include "common/base/shared/shared_cache.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/server/call_limiter.h"

namespace slicefarm::rpc {

/// Implementation of the service slicefarm.v1.SharedValues: stores values that the calls of a job
/// share, in total at most limits::kMaxKeptSharedBytes. Received bytes must match their digest.
/// Clients cannot read the values. The server's policy allows calls only to coordinators.
class SharedStore {
 public:
  explicit SharedStore(JsonLog log);
  ~SharedStore();

  SharedCache& cache() { return cache_; }
  grpc::Service& service() { return *service_; }

 private:
  SharedCache cache_;
  ByteBudget arriving_;
  CallLimiter gate_;
  std::unique_ptr<grpc::Service> service_;
};

}  // namespace slicefarm::rpc
