#pragma once

#include <grpcpp/server_context.h>

#include <cstdint>
#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/rate_limits.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/server/api/tenant_slots.h"

namespace slicefarm::coordinator {

/// Function that returns the current tenants. If the function is empty, there is a single tenant
/// without a name, to which every caller belongs.
using TenantsNow = std::function<std::shared_ptr<const Tenants>()>;

/// Largest number of calls in progress, including uploads and downloads. Tenants share them by the
/// rule of TenantSlots. Each call occupies a thread of the server.
struct CallLimits {
  int calls = 480;
};

/// Caller with its slot among the calls in progress. The destructor releases the slot.
struct AdmittedCaller : Caller {
  TenantSlots::Slot slot;
};

/// Marks that identify a caller in a log. A mark is empty if the caller did not send the data for
/// it.
struct CallerMarks {
  std::string tenant;       ///< tenant, if the caller is known
  std::string token;        ///< first 12 digits of the token's SHA-256
  std::string certificate;  ///< first 12 digits of the certificate's SHA-256
  std::string address;
};

/// Authenticates callers. Each method of the public services calls Find first. gRPC's
/// AuthMetadataProcessor is not used, because it exists only with TLS and its errors have no
/// details. Thread-safe.
class Callers {
 public:
  Callers(TenantsNow tenants, const CallLimits& limits, std::function<int64_t()> now_us)
      : tenants_(std::move(tenants)), now_us_(std::move(now_us)), slots_(limits.calls) {}

  /// Returns the caller with a slot for the call. The caller is identified by its token, or without
  /// a token by its certificate. If it sends both, they must belong to the same tenant. The caller
  /// must have at least one of the scopes `one_of`. Errors: UNAUTHENTICATED; PERMISSION_DENIED,
  /// with metadata `scope` if a scope is missing; OVERLOADED if too many calls of its tenant are in
  /// progress, or, with metadata `rate`, if its tenant makes too many calls per second.
  absl::StatusOr<AdmittedCaller> Find(const grpc::ServerContextBase& context,
                                      const Scopes& one_of) const;

  /// Returns the marks of any caller, also of a refused one.
  CallerMarks MarksOf(const grpc::ServerContextBase& context) const;

  /// Checks that the caller may create `jobs` jobs now. Errors: OVERLOADED, with metadata `rate`,
  /// if its tenant creates too many jobs per second.
  absl::Status CheckJobs(const Caller& caller, int64_t jobs) const;

 private:
  absl::StatusOr<Caller> Known(const grpc::ServerContextBase& context) const;

  const TenantsNow tenants_;
  const std::function<int64_t()> now_us_;
  mutable TenantSlots slots_;
  mutable RateLimits calls_;
  mutable RateLimits jobs_;
};

}  // namespace slicefarm::coordinator
