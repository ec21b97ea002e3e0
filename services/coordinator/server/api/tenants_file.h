#pragma once

#include <prometheus/gauge.h>
#include <prometheus/registry.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "absl/status/statusor.h"
#include "common/rpc/security/file_watch.h"
#include "common/rpc/observe/json_log.h"
#include "services/coordinator/algo/tenants.h"

namespace slicefarm::coordinator {

/// The tenants of a file, which is read again when it changes. A new content that cannot be used
/// leaves the last one in force, with an error in the log and slicefarm_tenants_file_usable at 0.
/// Thread-safe.
class TenantsFile {
 public:
  /// The registry must outlive it. Errors: those of rpc::ReadTextFile and ParseTenants.
  static absl::StatusOr<std::unique_ptr<TenantsFile>> Open(
      const std::string& path, prometheus::Registry& registry, rpc::JsonLog log,
      std::chrono::milliseconds every = std::chrono::seconds(1));

  std::shared_ptr<const Tenants> Get() const;

 private:
  TenantsFile(Tenants tenants, prometheus::Registry& registry, rpc::JsonLog log);
  void Reload(const absl::StatusOr<std::string>& text);

  const rpc::JsonLog log_;
  prometheus::Gauge& usable_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Tenants> tenants_;  // shared: calls that go on have the old ones
  std::optional<rpc::FileWatch> watch_;     ///< the last member: its thread uses the others
};

}  // namespace slicefarm::coordinator
