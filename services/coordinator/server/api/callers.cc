#include "services/coordinator/server/api/callers.h"

#include <algorithm>
#include <optional>
#include <string>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/rpc/security/bearer_token.h"
#include "common/rpc/security/call_peer.h"
#include "common/rpc/security/identity.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {
namespace {

absl::Status Unauthenticated(std::string_view message) {
  return MakeError(absl::StatusCode::kUnauthenticated, Reason::kUnauthenticated, message);
}

absl::Status Denied(std::string_view message, std::map<std::string, std::string> metadata = {}) {
  return MakeError(absl::StatusCode::kPermissionDenied, Reason::kPermissionDenied, message,
                   std::move(metadata));
}

/// Checks the rate of a tenant. `what`: "calls" or "jobs".
absl::Status CheckRate(RateLimits& limits, const std::string& tenant, const char* what,
                       int64_t per_second, int64_t count, int64_t now_us) {
  if (per_second == 0 || count == 0) return absl::OkStatus();
  const int64_t wait_us = limits.Take(tenant, per_second, count, now_us);
  if (wait_us == 0) return absl::OkStatus();
  return MakeError(absl::StatusCode::kResourceExhausted, Reason::kOverloaded,
                   absl::StrCat("the tenant may have ", per_second, " ", what, " a second"),
                   {{"rate", what},
                    {"limit", absl::StrCat(per_second)},
                    {rpc::kRetryAfterMs, absl::StrCat(wait_us / 1000 + 1)}});
}

}  // namespace

absl::Status Callers::CheckJobs(const Caller& caller, int64_t jobs) const {
  return CheckRate(jobs_, caller.tenant, "jobs", caller.max_jobs_per_second, jobs, now_us_());
}

CallerMarks Callers::MarksOf(const grpc::ServerContextBase& context) const {
  constexpr size_t kDigits = 12;
  CallerMarks marks;
  if (const auto caller = Known(context); caller.ok()) marks.tenant = caller->tenant;
  if (const auto token = rpc::BearerToken(context))
    marks.token = Sha256Hex(*token).substr(0, kDigits);
  const auto peer = rpc::PeerOf(context);
  if (peer.ok()) marks.certificate = peer->fingerprint.substr(0, kDigits);
  marks.address = peer.ok() ? peer->address : context.peer();
  return marks;
}

absl::StatusOr<AdmittedCaller> Callers::Find(const grpc::ServerContextBase& context,
                                             const Scopes& one_of) const {
  auto caller = Known(context);
  if (!caller.ok()) return caller.status();
  if (std::ranges::none_of(one_of, [&](Scope scope) { return caller->may(scope); })) {
    const std::string scope(ScopeName(*one_of.begin()));
    return Denied(absl::StrCat("this needs the scope '", scope, "'"), {{"scope", scope}});
  }
  absl::Status rate =
      CheckRate(calls_, caller->tenant, "calls", caller->max_calls_per_second, 1, now_us_());
  if (!rate.ok()) return rate;
  auto slot = slots_.Enter(caller->tenant);
  if (!slot.ok()) return slot.status();
  return AdmittedCaller{*std::move(caller), *std::move(slot)};
}

absl::StatusOr<Caller> Callers::Known(const grpc::ServerContextBase& context) const {
  const auto peer = rpc::PeerOf(context);
  if (!peer.ok()) return peer.status();
  const auto shown = rpc::TenantOfIdentity(peer->identity);
  if (!peer->identity.empty() && !shown) {
    return Denied(absl::StrCat("the certificate is ", peer->identity, "'s, and no tenant's"));
  }
  if (!tenants_) {
    // The CA may also sign certificates for other purposes.
    if (peer->certified && !shown) return Denied("the certificate names no tenant");
    return Caller{.tenant = "", .scopes = {Scope::kSubmit, Scope::kRead}};
  }
  const std::shared_ptr<const Tenants> tenants = tenants_();
  const std::optional<std::string> token = rpc::BearerToken(context);
  if (!token && !shown) return Unauthenticated("a token is needed: `authorization: Bearer TOKEN`");
  const auto caller = token ? CallerWithToken(*tenants, *token, now_us_())
                            : CallerWithCertificate(*tenants, *shown);
  if (!caller) {
    return Unauthenticated(token ? "the token is unknown or has expired"
                                 : "the tenant of the certificate is unknown");
  }
  if (shown && caller->tenant != *shown)
    return Denied("token and certificate belong to different tenants");
  return *caller;
}

}  // namespace slicefarm::coordinator
