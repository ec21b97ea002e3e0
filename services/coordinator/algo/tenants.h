#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "common/model/limits.h"

namespace slicefarm::coordinator {

/// What a token allows. None implies another.
enum class Scope {
  kSubmit,  ///< upload; create, cancel and delete jobs of the tenant
  kRead,    ///< get, list, watch and download jobs of the tenant
  kAdmin,   ///< get, list, watch and cancel jobs of all tenants
};

std::string_view ScopeName(Scope scope);
std::optional<Scope> ScopeFromName(std::string_view name);

using Scopes = std::set<Scope>;

/// A token as it is kept: who reads this cannot use it.
struct Token {
  std::string sha256;  ///< of the token's text
  Scopes scopes;
  int64_t expires_us = INT64_MAX;  ///< since 1970
};

struct Tenant {
  std::vector<Token>
      tokens;  ///< two at most, so that a new one can be handed out before the old goes
  Scopes certificate_scopes = {Scope::kSubmit, Scope::kRead};  ///< without a token
  int64_t max_open_jobs = limits::kMaxOpenJobs;
  int64_t max_kept_jobs = INT64_MAX;   ///< ended ones among them
  int64_t max_kept_bytes = INT64_MAX;  ///< of meshes, results and uploads
  int64_t max_calls_per_second = 0;    ///< on average (rate_limits.h); 0: any number
  int64_t max_jobs_per_second = 0;     ///< the same, of jobs that are created
  std::string default_profile = {};    ///< of jobs that name no printer; empty: they need one
};

using Tenants = std::map<std::string, Tenant, std::less<>>;

/// What the file of tenants says:
///
///   {"tenants": {
///     "acme": {
///       "tokens": [{"sha256": "64 hex digits", "scopes": ["submit", "read"],
///                   "expires": "2027-01-31T12:00:00Z"}],
///       "certificate_scopes": ["read"],
///       "max_open_jobs": 100,
///       "max_kept_jobs": 100000,
///       "max_kept_bytes": 500000000000,
///       "max_calls_per_second": 100,
///       "max_jobs_per_second": 10,
///       "default_profile": "mk4s"}}}
///
/// All but "sha256" and "scopes" may be left out. Errors: REQUEST_MALFORMED naming the place, also
/// for keys that are not known or stand twice, and for a token of two tenants.
absl::StatusOr<Tenants> ParseTenants(std::string_view json);

/// 1 to 63 of a-z, 0-9, '-' and '_', beginning with none of the last two: what may become part of a
/// path, and of a certificate's URI.
bool IsTenantName(std::string_view name);

/// Who calls, and what he may do.
struct Caller {
  std::string tenant;
  Scopes scopes;
  int64_t max_open_jobs = limits::kMaxOpenJobs;
  int64_t max_kept_jobs = INT64_MAX;
  int64_t max_kept_bytes = INT64_MAX;
  int64_t max_calls_per_second = 0;
  int64_t max_jobs_per_second = 0;
  std::string default_profile = {};

  bool may(Scope scope) const { return scopes.contains(scope); }
};

/// The one who has this token; nullopt if it is nobody's, or no longer. Takes the same time for any
/// token of the same length.
std::optional<Caller> CallerWithToken(const Tenants& tenants, std::string_view token,
                                      int64_t now_us);

/// The one who has shown a certificate of this tenant.
std::optional<Caller> CallerWithCertificate(const Tenants& tenants, std::string_view tenant);

}  // namespace slicefarm::coordinator
