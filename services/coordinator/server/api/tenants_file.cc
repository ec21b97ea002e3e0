#include "services/coordinator/server/api/tenants_file.h"

#include <utility>

namespace slicefarm::coordinator {

absl::StatusOr<std::unique_ptr<TenantsFile>> TenantsFile::Open(const std::string& path,
                                                               prometheus::Registry& registry,
                                                               rpc::JsonLog log,
                                                               std::chrono::milliseconds every) {
  auto text = rpc::ReadTextFile(path);
  if (!text.ok()) return text.status();
  auto tenants = ParseTenants(*text);
  if (!tenants.ok()) return tenants.status();
  std::unique_ptr<TenantsFile> file(new TenantsFile(*std::move(tenants), registry, std::move(log)));
  file->watch_.emplace(
      path, *std::move(text), [&self = *file](const auto& changed) { self.Reload(changed); },
      every);
  return file;
}

TenantsFile::TenantsFile(Tenants tenants, prometheus::Registry& registry, rpc::JsonLog log)
    : log_(std::move(log)),
      usable_(prometheus::BuildGauge()
                  .Name("slicefarm_tenants_file_usable")
                  .Help("0: the file of tenants as it is now cannot be used, an older one holds")
                  .Register(registry)
                  .Add({})),
      tenants_(std::make_shared<const Tenants>(std::move(tenants))) {
  usable_.Set(1);
}

std::shared_ptr<const Tenants> TenantsFile::Get() const {
  const std::lock_guard lock(mutex_);
  return tenants_;
}

void TenantsFile::Reload(const absl::StatusOr<std::string>& text) {
  auto tenants = text.ok() ? ParseTenants(*text) : text.status();
  usable_.Set(tenants.ok() ? 1 : 0);
  if (!tenants.ok()) {
    return log_.Error("the last file of tenants stays in force",
                      {{"error", std::string(tenants.status().message())}});
  }
  log_.Info("new file of tenants", {{"tenants", static_cast<int64_t>(tenants->size())}});
  const std::lock_guard lock(mutex_);
  tenants_ = std::make_shared<const Tenants>(*std::move(tenants));
}

}  // namespace slicefarm::coordinator
