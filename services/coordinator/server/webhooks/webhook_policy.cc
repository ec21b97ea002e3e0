#include "services/coordinator/server/webhooks/webhook_policy.h"

#include <curl/curl.h>
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/model/scene/scene.h"

namespace slicefarm::coordinator {
namespace {

using Json = nlohmann::ordered_json;

constexpr size_t kMinSecretBytes = 16;
/// Two secrets: the new one and the one that it replaces.
constexpr size_t kMaxSecrets = 2;

struct Url {
  std::string origin;  ///< scheme, host and port, in normalized form
  std::string path;
};

std::string Part(CURLU* url, CURLUPart part, unsigned int flags = 0) {
  char* text = nullptr;
  if (curl_url_get(url, part, &text, CURLU_DEFAULT_PORT | flags) != CURLUE_OK) return {};
  std::string value = text;
  curl_free(text);
  return value;
}

/// Parses a URL. Returns nullopt if it is not an http(s) URL or if it contains a user's name.
std::optional<Url> ParseUrl(const std::string& text) {
  const std::unique_ptr<CURLU, decltype(&curl_url_cleanup)> url(curl_url(), &curl_url_cleanup);
  if (curl_url_set(url.get(), CURLUPART_URL, text.c_str(), CURLU_DISALLOW_USER) != CURLUE_OK) {
    return std::nullopt;
  }
  const std::string scheme = Part(url.get(), CURLUPART_SCHEME);
  if (scheme != "http" && scheme != "https") return std::nullopt;
  // The path is decoded for this check, because a receiver may decode it before it resolves it.
  const std::string decoded = Part(url.get(), CURLUPART_PATH, CURLU_URLDECODE);
  if (decoded.empty()) return std::nullopt;  // the path contains control characters
  if ((decoded + "/").find("/../") != std::string::npos) return std::nullopt;
  std::string host = Part(url.get(), CURLUPART_HOST);
  std::ranges::transform(host, host.begin(), [](unsigned char c) { return std::tolower(c); });
  return Url{fmt::format("{}://{}:{}", scheme, host, Part(url.get(), CURLUPART_PORT)),
             Part(url.get(), CURLUPART_PATH)};
}

bool IsBelow(const std::string& path, const std::string& parent) {
  if (!path.starts_with(parent)) return false;
  return path.size() == parent.size() || parent.ends_with('/') || path[parent.size()] == '/';
}

absl::Status Invalid(const std::string& tenant, std::string_view key, std::string_view why) {
  return absl::InvalidArgumentError(fmt::format("webhooks: \"{}\": {}: {}", tenant, key, why));
}

absl::Status TakeAllow(const std::string& tenant, const Json& value, WebhookRules& rules) {
  if (!value.is_array()) return Invalid(tenant, "allow", "a list of URLs is needed");
  for (const Json& url : value) {
    if (!url.is_string() || !ParseUrl(url.get<std::string>())) {
      return Invalid(tenant, "allow", fmt::format("{} is not an http(s) URL", url.dump()));
    }
    rules.allow.push_back(url.get<std::string>());
  }
  return absl::OkStatus();
}

/// Reads the secrets of a tenant. `value`: a secret, or a list of secrets.
absl::Status TakeSecrets(const std::string& tenant, const std::string& key, const Json& value,
                         WebhookRules& rules) {
  if (!rules.secrets.empty())
    return Invalid(tenant, key, "\"secret\" and \"secrets\" exclude each other");
  const Json list = value.is_array() ? value : Json::array({value});
  if (list.empty() || list.size() > kMaxSecrets)
    return Invalid(tenant, key, fmt::format("1 to {} secrets are needed", kMaxSecrets));
  for (const Json& secret : list) {
    if (!secret.is_string() || secret.get_ref<const std::string&>().size() < kMinSecretBytes)
      return Invalid(tenant, key, fmt::format("{} bytes or more are needed", kMinSecretBytes));
    rules.secrets.push_back(secret.get<std::string>());
  }
  return absl::OkStatus();
}

absl::StatusOr<WebhookRules> RulesFrom(const std::string& tenant, const Json& json) {
  if (!json.is_object()) return Invalid(tenant, "its value", "an object is needed");
  WebhookRules rules;
  for (const auto& [key, value] : json.items()) {
    if (key == "allow") {
      if (absl::Status taken = TakeAllow(tenant, value, rules); !taken.ok()) return taken;
    } else if ((key == "secret" && value.is_string()) || (key == "secrets" && value.is_array())) {
      if (absl::Status taken = TakeSecrets(tenant, key, value, rules); !taken.ok()) return taken;
    } else if (key == "private" && value.is_boolean()) {
      rules.private_addresses = value.get<bool>();
    } else {
      return Invalid(tenant, key, "is unknown, or has another type");
    }
  }
  if (rules.secrets.empty()) return Invalid(tenant, "secret", "there is none");
  return rules;
}

absl::Status Refused(const std::string& url, std::string_view why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kWebhookRefused,
                   fmt::format("webhook {}: {}", url, why), {{"url", url}});
}

}  // namespace

absl::StatusOr<WebhookPolicy> WebhookPolicy::Parse(std::string_view text) {
  const Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object()) return absl::InvalidArgumentError("webhooks: a JSON object is needed");
  WebhookPolicy policy;
  for (const auto& [tenant, value] : json.items()) {
    auto rules = RulesFrom(tenant, value);
    if (!rules.ok()) return rules.status();
    policy.rules_[tenant] = *std::move(rules);
  }
  return policy;
}

absl::Status WebhookPolicy::Check(const std::string& tenant, const std::string& url) const {
  if (std::ssize(url) > limits::kMaxUrlBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of a URL", limits::kMaxUrlBytes,
                      std::ssize(url));
  }
  const WebhookRules* rules = RulesOf(tenant);
  if (rules == nullptr) return Refused(url, "this farm sends no webhooks");
  const std::optional<Url> wanted = ParseUrl(url);
  if (!wanted) return Refused(url, "is not an http(s) URL, or contains a user name");
  for (const std::string& entry : rules->allow) {
    const std::optional<Url> allowed = ParseUrl(entry);
    if (allowed->origin == wanted->origin && IsBelow(wanted->path, allowed->path)) {
      return absl::OkStatus();
    }
  }
  return Refused(url, "is not one of the allowed targets");
}

const WebhookRules* WebhookPolicy::RulesOf(const std::string& tenant) const {
  const auto found = rules_.find(tenant);
  return found == rules_.end() ? nullptr : &found->second;
}

}  // namespace slicefarm::coordinator
