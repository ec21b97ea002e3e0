#pragma once

#include <grpcpp/server_context.h>

#include <cstdint>
#include <functional>
#include <memory>

#include "absl/status/statusor.h"
#include "services/coordinator/algo/rate_limits.h"
#include "services/coordinator/algo/tenants.h"
#include "services/coordinator/server/api/tenant_places.h"

namespace slicefarm::coordinator {

/// The tenants at the moment. None: there is one only, without a name, and each caller is it.
using TenantsNow = std::function<std::shared_ptr<const Tenants>()>;

/// How many calls may be under way at once, uploads and downloads among them, shared as
/// TenantPlaces says: each holds a thread of the server.
struct CallLimits {
  int calls = 480;
};

/// Who calls, and his place among the calls that are under way, given back when this goes.
struct PlacedCaller : Caller {
  TenantPlaces::Place place;
};

/// By what a caller is known again in a log; what he did not show is empty.
struct CallerMarks {
  std::string tenant;       ///< of a caller who is known
  std::string token;        ///< the first 12 digits of its SHA-256
  std::string certificate;  ///< the same
  std::string address;
};

/// Finds out who calls: the first thing that each method of the public services does. Not gRPC's
/// AuthMetadataProcessor, which there is with TLS only, and whose errors have no details.
/// Thread-safe.
class Callers {
 public:
  Callers(TenantsNow tenants, const CallLimits& limits, std::function<int64_t()> now_us)
      : tenants_(std::move(tenants)), now_us_(std::move(now_us)), places_(limits.calls) {}

  /// The caller, by his token, or else by his certificate (with both, they must be of one tenant).
  /// He has at least one of the scopes. Errors: UNAUTHENTICATED; PERMISSION_DENIED, with metadata
  /// `scope` if it is one that he lacks; OVERLOADED if too many calls of his tenant are under way,
  /// or, with metadata `rate`, if his tenant makes more calls a second than it may.
  absl::StatusOr<PlacedCaller> Find(const grpc::ServerContextBase& context,
                                    const Scopes& one_of) const;

  /// Of any caller, also one who is refused.
  CallerMarks MarksOf(const grpc::ServerContextBase& context) const;

  /// Before the caller creates so many jobs. Errors: OVERLOADED, with metadata `rate`, if his
  /// tenant creates more a second than it may.
  absl::Status CheckJobs(const Caller& caller, int64_t jobs) const;

 private:
  absl::StatusOr<Caller> Known(const grpc::ServerContextBase& context) const;

  const TenantsNow tenants_;
  const std::function<int64_t()> now_us_;
  mutable TenantPlaces places_;
  mutable RateLimits calls_;
  mutable RateLimits jobs_;
};

}  // namespace slicefarm::coordinator
