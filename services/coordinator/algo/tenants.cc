#include "services/coordinator/algo/tenants.h"

#include <openssl/crypto.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <utility>

#include "absl/strings/str_cat.h"
#include "absl/time/time.h"
#include "common/base/error.h"
#include "common/base/sha256.h"

namespace slicefarm::coordinator {
namespace {

using Json = nlohmann::json;

constexpr std::array kScopeNames = std::to_array<std::pair<Scope, std::string_view>>(
    {{Scope::kSubmit, "submit"}, {Scope::kRead, "read"}, {Scope::kAdmin, "admin"}});

constexpr size_t kMaxTokens = 2;
constexpr size_t kMaxNameBytes = 63;
constexpr int64_t kMaxPerSecond = 1'000'000;

/// Reads the parts of the file. Keeps the first error.
class Reader {
 public:
  const absl::Status& status() const { return status_; }

  Tenants Read(std::string_view text) {
    Tenants tenants;
    const Json json = Parse(text);
    if (!CheckKeys(json, "the file", {"tenants"}, {"tenants"})) return tenants;
    const Json& list = json["tenants"];
    if (!list.is_object()) Fail("tenants", "is not an object");
    if (!status_.ok()) return tenants;
    for (const auto& [name, tenant] : list.items()) {
      if (!IsTenantName(name)) Fail("tenants", absl::StrCat("has a name that cannot be: ", name));
      tenants[name] = ReadTenant(tenant, absl::StrCat("tenants.", name));
    }
    return tenants;
  }

 private:
  /// Parses the text and rejects duplicate keys. nlohmann::json keeps only the last value of a
  /// duplicate key, so a tenant could be missing without an error.
  Json Parse(std::string_view text) {
    std::vector<std::set<std::string>> objects;
    const auto note = [&](int /*depth*/, Json::parse_event_t event, Json& parsed) {
      if (event == Json::parse_event_t::object_start) objects.emplace_back();
      if (event == Json::parse_event_t::object_end) objects.pop_back();
      if (event == Json::parse_event_t::key &&
          !objects.back().insert(parsed.get<std::string>()).second) {
        Fail("the file", absl::StrCat("has a key twice: ", parsed.get<std::string>()));
      }
      return true;
    };
    Json json = Json::parse(text, note, /*allow_exceptions=*/false);
    if (json.is_discarded()) Fail("the file", "is not JSON");
    return json;
  }

  Tenant ReadTenant(const Json& json, const std::string& place) {
    Tenant tenant;
    if (!CheckKeys(
            json, place,
            {"tokens", "certificate_scopes", "max_open_jobs", "max_kept_jobs", "max_kept_bytes",
             "max_calls_per_second", "max_jobs_per_second", "default_profile"},
            {})) {
      return tenant;
    }
    if (json.contains("tokens")) tenant.tokens = ReadTokens(json["tokens"], place + ".tokens");
    if (json.contains("certificate_scopes")) {
      tenant.certificate_scopes =
          ReadScopes(json["certificate_scopes"], place + ".certificate_scopes");
    }
    ReadMost(json, place, "max_open_jobs", limits::kMaxOpenJobs, tenant.max_open_jobs);
    ReadMost(json, place, "max_kept_jobs", INT64_MAX, tenant.max_kept_jobs);
    ReadMost(json, place, "max_kept_bytes", INT64_MAX, tenant.max_kept_bytes);
    ReadMost(json, place, "max_calls_per_second", kMaxPerSecond, tenant.max_calls_per_second);
    ReadMost(json, place, "max_jobs_per_second", kMaxPerSecond, tenant.max_jobs_per_second);
    if (json.contains("default_profile")) {
      const Json& name = json["default_profile"];
      if (!name.is_string()) Fail(place + ".default_profile", "is not the name of a profile");
      if (name.is_string()) tenant.default_profile = name.get<std::string>();
    }
    return tenant;
  }

  /// Reads a limit from 1 to `most` into `value`, if the key exists.
  void ReadMost(const Json& json, const std::string& place, const std::string& key, int64_t most,
                int64_t& value) {
    if (!json.contains(key)) return;
    const Json& max = json[key];
    if (max.is_number_integer() && max.get<int64_t>() >= 1 && max.get<int64_t>() <= most) {
      value = max.get<int64_t>();
    } else {
      Fail(absl::StrCat(place, ".", key), absl::StrCat("is not a number from 1 to ", most));
    }
  }

  std::vector<Token> ReadTokens(const Json& json, const std::string& place) {
    std::vector<Token> tokens;
    if (!json.is_array() || json.size() > kMaxTokens) {
      Fail(place, absl::StrCat("is not a list of at most ", kMaxTokens));
      return tokens;
    }
    for (size_t i = 0; i < json.size(); ++i) {
      tokens.push_back(ReadToken(json[i], absl::StrCat(place, "[", i, "]")));
    }
    return tokens;
  }

  Token ReadToken(const Json& json, const std::string& place) {
    Token token;
    if (!CheckKeys(json, place, {"sha256", "scopes", "expires"}, {"sha256", "scopes"})) {
      return token;
    }
    const Json& sha256 = json["sha256"];
    if (!sha256.is_string() || !IsSha256Hex(sha256.get<std::string>())) {
      Fail(place + ".sha256", "is not a SHA-256, 64 lower-case hex digits");
      return token;
    }
    token.sha256 = sha256.get<std::string>();
    if (!tokens_.insert(token.sha256).second) Fail(place, "is in the file twice");
    token.scopes = ReadScopes(json["scopes"], place + ".scopes");
    if (json.contains("expires")) token.expires_us = ReadTime(json["expires"], place + ".expires");
    return token;
  }

  Scopes ReadScopes(const Json& json, const std::string& place) {
    Scopes scopes;
    if (!json.is_array()) {
      Fail(place, "is not a list");
      return scopes;
    }
    for (const Json& name : json) {
      const auto scope = name.is_string() ? ScopeFromName(name.get<std::string>()) : std::nullopt;
      if (!scope) {
        Fail(place, absl::StrCat("contains an unknown scope (scopes are submit, read, admin): ",
                                 name.dump(-1, ' ', true, Json::error_handler_t::replace)));
        return scopes;
      }
      scopes.insert(*scope);
    }
    return scopes;
  }

  int64_t ReadTime(const Json& json, const std::string& place) {
    absl::Time time;
    std::string error;
    if (!json.is_string() ||
        !absl::ParseTime(absl::RFC3339_full, json.get<std::string>(), &time, &error)) {
      Fail(place, "is not a time such as 2027-01-31T12:00:00Z");
      return 0;
    }
    return absl::ToUnixMicros(time);
  }

  /// Returns true if `json` is an object that has only these keys.
  bool CheckKeys(const Json& json, const std::string& place, const std::set<std::string>& known,
                 const std::set<std::string>& needed) {
    if (!json.is_object()) Fail(place, "is not an object");
    if (!status_.ok()) return false;
    for (const auto& [key, value] : json.items()) {
      if (!known.contains(key)) Fail(place, absl::StrCat("has an unknown key: ", key));
    }
    for (const std::string& key : needed) {
      if (!json.contains(key)) Fail(place, absl::StrCat("has no ", key));
    }
    return status_.ok();
  }

  void Fail(const std::string& place, const std::string& what) {
    status_.Update(MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                             absl::StrCat(place, " ", what), {{"place", place}}));
  }

  absl::Status status_;
  std::set<std::string> tokens_;  ///< tokens read so far
};

Caller CallerOf(const std::string& name, const Tenant& tenant, const Scopes& scopes) {
  return {name,
          scopes,
          tenant.max_open_jobs,
          tenant.max_kept_jobs,
          tenant.max_kept_bytes,
          tenant.max_calls_per_second,
          tenant.max_jobs_per_second,
          tenant.default_profile};
}

}  // namespace

std::string_view ScopeName(Scope scope) {
  for (const auto& [value, name] : kScopeNames) {
    if (value == scope) return name;
  }
  return "";
}

std::optional<Scope> ScopeFromName(std::string_view name) {
  for (const auto& [value, known] : kScopeNames) {
    if (known == name) return value;
  }
  return std::nullopt;
}

absl::StatusOr<Tenants> ParseTenants(std::string_view json) {
  Reader reader;
  Tenants tenants = reader.Read(json);
  if (!reader.status().ok()) return reader.status();
  return tenants;
}

bool IsTenantName(std::string_view name) {
  const auto is_alnum = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'); };
  return !name.empty() && name.size() <= kMaxNameBytes && is_alnum(name.front()) &&
         std::ranges::all_of(name, [&](char c) { return is_alnum(c) || c == '-' || c == '_'; });
}

std::optional<Caller> CallerWithToken(const Tenants& tenants, std::string_view token,
                                      int64_t now_us) {
  const std::string sha256 = Sha256Hex(token);
  std::optional<Caller> caller;
  for (const auto& [name, tenant] : tenants) {
    for (const Token& known : tenant.tokens) {
      // The loop compares every byte of every digest, so the time does not reveal how close a guess
      // was.
      const bool same = CRYPTO_memcmp(known.sha256.data(), sha256.data(), sha256.size()) == 0;
      if (same && now_us < known.expires_us) caller = CallerOf(name, tenant, known.scopes);
    }
  }
  return caller;
}

std::optional<Caller> CallerWithCertificate(const Tenants& tenants, std::string_view tenant) {
  const auto found = tenants.find(tenant);
  if (found == tenants.end()) return std::nullopt;
  return CallerOf(found->first, found->second, found->second.certificate_scopes);
}

}  // namespace slicefarm::coordinator
