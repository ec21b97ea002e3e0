#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Where a tenant's webhooks may go, and how they are signed.
struct WebhookRules {
  std::vector<std::string> allow;  ///< URLs: the same scheme, host and port, and paths below
  std::string secret;              ///< of the HMAC
  bool private_addresses = false;  ///< may they lead into a private network?
};

/// The webhooks that the farm sends, by tenant; "" stands for all where there are none.
class WebhookPolicy {
 public:
  /// JSON: `{"TENANT": {"allow": ["https://host/path"], "secret": "...", "private": false}}`.
  /// Errors: InvalidArgument naming the key.
  static absl::StatusOr<WebhookPolicy> Parse(std::string_view json);
  static absl::StatusOr<WebhookPolicy> Read(const std::string& path);

  /// Errors: REQUEST_TOO_LARGE; WEBHOOK_REFUSED for what is no URL or on no list of the tenant.
  absl::Status Check(const std::string& tenant, const std::string& url) const;

  /// Null: the tenant has none.
  const WebhookRules* RulesOf(const std::string& tenant) const;

 private:
  std::map<std::string, WebhookRules> rules_;
};

}  // namespace slicefarm::coordinator
