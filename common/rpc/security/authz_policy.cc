#include "common/rpc/security/authz_policy.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::rpc {
namespace {

using Json = nlohmann::json;

bool Fits(std::string_view pattern, std::string_view text) {
  if (pattern == "*") return !text.empty();
  if (pattern.ends_with('*')) return text.starts_with(pattern.substr(0, pattern.size() - 1));
  if (pattern.starts_with('*')) return text.ends_with(pattern.substr(1));
  return text == pattern;
}

bool FitsOne(const std::vector<std::string>& patterns, std::string_view text) {
  return patterns.empty() ||
         std::ranges::any_of(patterns, [&](const auto& pattern) { return Fits(pattern, text); });
}

}  // namespace

/// Reads the parts of a policy. It keeps the first error.
class PolicyReader {
 public:
  const absl::Status& status() const { return status_; }

  void ReadPolicy(const Json& json, AuthzPolicy& policy) {
    if (!CheckKeys(json, "the policy", {"name", "deny_rules", "allow_rules"})) return;
    if (!json.contains("allow_rules")) return Fail("the policy", "has no allow_rules");
    ReadRules(json, "deny_rules", policy.deny_);
    ReadRules(json, "allow_rules", policy.allow_);
  }

 private:
  void ReadRules(const Json& policy, const std::string& key,
                 std::vector<AuthzPolicy::Rule>& rules) {
    if (!policy.contains(key)) return;
    const Json& list = policy[key];
    if (!list.is_array()) return Fail(key, "is not a list");
    for (size_t i = 0; i < list.size(); ++i) {
      ReadRule(list[i], absl::StrCat(key, "[", i, "]"), rules.emplace_back());
    }
  }

  void ReadRule(const Json& json, const std::string& place, AuthzPolicy::Rule& rule) {
    if (!CheckKeys(json, place, {"name", "source", "request"})) return;
    ReadPatterns(json, place, "source", "principals", rule.principals);
    ReadPatterns(json, place, "request", "paths", rule.paths);
  }

  /// Reads the list `rule.part.key`. An empty list is refused, because it could mean that nothing
  /// matches or that everything matches.
  void ReadPatterns(const Json& rule, const std::string& place, const std::string& part,
                    const std::string& key, std::vector<std::string>& patterns) {
    if (!rule.contains(part)) return;
    const std::string where = absl::StrCat(place, ".", part);
    if (!CheckKeys(rule[part], where, {key}) || !rule[part].contains(key)) return;
    const Json& list = rule[part][key];
    const bool texts = list.is_array() && !list.empty() &&
                       std::ranges::all_of(list, [](const Json& j) { return j.is_string(); });
    if (!texts) return Fail(where + "." + key, "is not a list of patterns");
    patterns = list.get<std::vector<std::string>>();
  }

  /// Returns true if `json` is an object that has only these keys, and its name, if present, is a
  /// text.
  bool CheckKeys(const Json& json, const std::string& place, std::vector<std::string> known) {
    if (!json.is_object()) {
      Fail(place, "is not an object");
      return false;
    }
    for (const auto& [key, value] : json.items()) {
      if (std::ranges::find(known, key) == known.end()) Fail(place, "has an unknown key: " + key);
      if (key == "name" && !value.is_string()) Fail(place, "has a name that is no text");
    }
    return status_.ok();
  }

  void Fail(const std::string& place, const std::string& what) {
    status_.Update(MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                             absl::StrCat("authorization policy: ", place, " ", what)));
  }

  absl::Status status_;
};

absl::StatusOr<AuthzPolicy> AuthzPolicy::Parse(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  AuthzPolicy policy;
  PolicyReader reader;
  reader.ReadPolicy(json, policy);
  if (!reader.status().ok()) return reader.status();
  return policy;
}

bool AuthzPolicy::Allows(std::string_view principal, std::string_view path) const {
  const auto fits = [&](const Rule& rule) {
    return FitsOne(rule.principals, principal) && FitsOne(rule.paths, path);
  };
  return std::ranges::none_of(deny_, fits) && std::ranges::any_of(allow_, fits);
}

}  // namespace slicefarm::rpc
