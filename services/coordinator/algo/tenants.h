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

/// Permission of a token. No scope implies another.
enum class Scope {
  kSubmit,  ///< upload meshes; create, cancel and delete jobs of the tenant
  kRead,    ///< get, list, watch and download jobs of the tenant
  kAdmin,   ///< get, list, watch and cancel jobs of all tenants
};

/// Returns the name of the scope in the file of tenants.
std::string_view ScopeName(Scope scope);
/// Returns the scope with this name; nullopt if there is none.
std::optional<Scope> ScopeFromName(std::string_view name);

using Scopes = std::set<Scope>;

/// Stored form of a token. It does not contain the token itself, so a person who reads it cannot
/// log in.
struct Token {
  std::string sha256;  ///< SHA-256 of the token's text
  Scopes scopes;
  int64_t expires_us = INT64_MAX;  ///< expiry time, in us since 1970
};

/// Tokens and limits of a tenant.
struct Tenant {
  /// At most two tokens, so that a new token can be distributed before the old one expires.
  std::vector<Token> tokens;
  /// Scopes of a client with a certificate and no token.
  Scopes certificate_scopes = {Scope::kSubmit, Scope::kRead};
  int64_t max_open_jobs = limits::kMaxOpenJobs;
  int64_t max_kept_jobs = INT64_MAX;   ///< limit of stored jobs, including jobs that ended
  int64_t max_kept_bytes = INT64_MAX;  ///< limit of stored bytes of meshes, results and uploads
  int64_t max_calls_per_second = 0;    ///< average limit of calls (rate_limits.h); 0: no limit
  /// Average limit of created jobs (rate_limits.h); 0: no limit.
  int64_t max_jobs_per_second = 0;
  /// Profile of jobs that name no printer; if empty, each job must name one.
  std::string default_profile = {};
};

using Tenants = std::map<std::string, Tenant, std::less<>>;

/// Reads the file of tenants:
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
/// Only "sha256" and "scopes" of a token are required. Errors: REQUEST_MALFORMED with the position
/// in the file, also for unknown or duplicate keys and for a token that two tenants have.
absl::StatusOr<Tenants> ParseTenants(std::string_view json);

/// Returns true if the name has 1 to 63 of a-z, 0-9, '-' and '_' and begins with a letter or a
/// digit. A name of this form may be part of a path and of a certificate's URI.
bool IsTenantName(std::string_view name);

/// Authenticated client with its permissions and limits.
struct Caller {
  std::string tenant;
  Scopes scopes;
  int64_t max_open_jobs = limits::kMaxOpenJobs;
  int64_t max_kept_jobs = INT64_MAX;
  int64_t max_kept_bytes = INT64_MAX;
  int64_t max_calls_per_second = 0;
  int64_t max_jobs_per_second = 0;
  std::string default_profile = {};

  /// Returns true if the caller has the scope.
  bool may(Scope scope) const { return scopes.contains(scope); }
};

/// Returns the caller with this token; nullopt if no tenant has the token or if the token has
/// expired. Takes the same time for all tokens of the same length.
std::optional<Caller> CallerWithToken(const Tenants& tenants, std::string_view token,
                                      int64_t now_us);

/// Returns the caller that has presented a certificate of this tenant; nullopt if the tenant does
/// not exist.
std::optional<Caller> CallerWithCertificate(const Tenants& tenants, std::string_view tenant);

}  // namespace slicefarm::coordinator
