#pragma once

#include <prometheus/gauge.h>
#include <prometheus/registry.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "absl/status/statusor.h"
#include "common/rpc/observe/json_log.h"
#include "common/rpc/security/file_watch.h"

namespace slicefarm::coordinator {

/// Settings file that is read again when it changes. If the new content is invalid, the old content
/// stays in use; the log gets an error, and the gauge slicefarm_NAME_file_usable becomes 0.
/// Thread-safe.
template <typename Content>
class ReloadedFile {
 public:
  using Parse = std::function<absl::StatusOr<Content>(const std::string& text)>;

  /// Opens the file and reads its content. `name`: kind of content, for the log and the gauge. The
  /// registry must outlive the file. Errors: see rpc::ReadTextFile; errors of `parse`.
  static absl::StatusOr<std::unique_ptr<ReloadedFile>> Open(
      const std::string& path, const std::string& name, Parse parse, prometheus::Registry& registry,
      rpc::JsonLog log, std::chrono::milliseconds every = std::chrono::seconds(1)) {
    auto text = rpc::ReadTextFile(path);
    if (!text.ok()) return text.status();
    auto content = parse(*text);
    if (!content.ok()) return content.status();
    std::unique_ptr<ReloadedFile> file(
        new ReloadedFile(*std::move(content), name, std::move(parse), registry, std::move(log)));
    file->watch_.emplace(
        path, *std::move(text), [&self = *file](const auto& changed) { self.Reload(changed); },
        every);
    return file;
  }

  /// Returns the current content.
  std::shared_ptr<const Content> Get() const {
    const std::lock_guard lock(mutex_);
    return content_;
  }

 private:
  ReloadedFile(Content content, const std::string& name, Parse parse,
               prometheus::Registry& registry, rpc::JsonLog log)
      : name_(name),
        parse_(std::move(parse)),
        log_(std::move(log)),
        usable_(prometheus::BuildGauge()
                    .Name("slicefarm_" + name + "_file_usable")
                    .Help("0: the file of " + name + " cannot be used and an older content applies")
                    .Register(registry)
                    .Add({})),
        content_(std::make_shared<const Content>(std::move(content))) {
    usable_.Set(1);
  }

  void Reload(const absl::StatusOr<std::string>& text) {
    auto content = text.ok() ? parse_(*text) : text.status();
    usable_.Set(content.ok() ? 1 : 0);
    if (!content.ok()) {
      return log_.Error("the last file of " + name_ + " remains in use",
                        {{"error", std::string(content.status().message())}});
    }
    log_.Info("new file of " + name_, {});
    const std::lock_guard lock(mutex_);
    content_ = std::make_shared<const Content>(*std::move(content));
  }

  const std::string name_;
  const Parse parse_;
  const rpc::JsonLog log_;
  prometheus::Gauge& usable_;
  mutable std::mutex mutex_;
  // Shared, because running calls continue with the old content.
  std::shared_ptr<const Content> content_;
  std::optional<rpc::FileWatch> watch_;  ///< last member, because its thread uses the other members
};

}  // namespace slicefarm::coordinator
