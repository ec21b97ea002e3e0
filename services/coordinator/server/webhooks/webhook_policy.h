#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"

namespace slicefarm::coordinator {

/// Where a tenant's webhooks may go, and how they are signed.
struct WebhookRules {
  std::vector<std::string> allow;  ///< URLs: the same scheme, host and port, and paths below
  std::vector<std::string>
      secrets;  ///< of the HMACs: one, or while it is replaced the new and the old
  bool private_addresses = false;  ///< may they lead into a private network?
};

/// The webhooks that the farm sends, by tenant; "" stands for all where there are none.
class WebhookPolicy {
 public:
  /// JSON: `{"TENANT": {"allow": ["https://host/path"], "secret": "...", "private": false}}`, or
  /// `"secrets": ["NEW", "OLD"]` in place of `secret`. Errors: InvalidArgument naming the key.
  static absl::StatusOr<WebhookPolicy> Parse(std::string_view json);

  /// Errors: REQUEST_TOO_LARGE; WEBHOOK_REFUSED for what is no URL or on no list of the tenant.
  absl::Status Check(const std::string& tenant, const std::string& url) const;

  /// Null: the tenant has none.
  const WebhookRules* RulesOf(const std::string& tenant) const;

 private:
  std::map<std::string, WebhookRules> rules_;
};

/// The policy that is in force: its file may change while the farm runs. Never null.
using WebhooksNow = std::function<std::shared_ptr<const WebhookPolicy>()>;

}  // namespace slicefarm::coordinator
