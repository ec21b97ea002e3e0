#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Allowed URLs of a tenant's webhooks, and the secrets with which their messages are signed.
struct WebhookRules {
  /// URL prefixes. The URL of a webhook must have the scheme, host and port of one prefix. Its path
  /// must be the prefix's path or a path below it.
  std::vector<std::string> allow;
  /// Secrets of the HMACs: one, or the new and the old one during a replacement.
  std::vector<std::string> secrets;
  bool private_addresses = false;  ///< true if the host may be in a private network
};

/// Rules for the webhooks of a farm, by tenant. The name "" is for a farm without tenants.
class WebhookPolicy {
 public:
  /// Reads the JSON `{"TENANT": {"allow": ["https://host/path"], "secret": "...", "private":
  /// false}}`. `"secrets": ["NEW", "OLD"]` may replace `secret`. Errors: InvalidArgument with the
  /// faulty key.
  static absl::StatusOr<WebhookPolicy> Parse(std::string_view json);

  /// Checks that the tenant's webhooks may use the URL. Errors: REQUEST_TOO_LARGE; WEBHOOK_REFUSED
  /// if it is no URL or if the tenant's list does not allow it.
  absl::Status Check(const std::string& tenant, const std::string& url) const;

  /// Returns the rules of a tenant; null if it has none.
  const WebhookRules* RulesOf(const std::string& tenant) const;

 private:
  std::map<std::string, WebhookRules> rules_;
};

/// Function that returns the current policy, which may change while the farm runs. Never null.
using WebhooksNow = std::function<std::shared_ptr<const WebhookPolicy>()>;

}  // namespace slicefarm::coordinator
