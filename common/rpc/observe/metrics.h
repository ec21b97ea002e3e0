#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/rpc/observe/http_pages.h"
#include "prometheus/collectable.h"
#include "prometheus/registry.h"

namespace slicefarm::rpc {

/// The metrics of one process and the port that shows them to Prometheus (GET /metrics), and pages
/// to people. Its own: process_cpu_seconds_total, process_resident_memory_bytes, process_open_fds
/// and slicefarm_build_info. Thread-safe.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// For families of one's own. Units stand in the name, base units, no label of free text.
  prometheus::Registry& registry() { return registry_; }

  /// Shows values that are looked up when Prometheus asks. Before Serve.
  void Show(std::shared_ptr<prometheus::Collectable> values) {
    shown_.push_back(std::move(values));
  }

  /// Shows a page of HTML on the same port. Before Serve.
  void ShowPage(const std::string& path, std::function<std::string()> html) {
    pages_.push_back({path, "text/html; charset=utf-8", std::move(html)});
  }

  /// Serves on `address` (host:port, port 0: any); returns the port. Errors: Unavailable if it
  /// cannot listen there.
  absl::StatusOr<int> Serve(const std::string& address);

  /// Waits for a scrape that is being answered, and serves no more: what is shown may go.
  void Stop();

  /// What Prometheus reads.
  std::string Text() const;

 private:
  prometheus::Registry registry_;
  std::vector<std::shared_ptr<prometheus::Collectable>> shown_;  // shared with who made them
  std::vector<HttpPage> pages_;
  std::unique_ptr<HttpPages> server_;
};

}  // namespace slicefarm::rpc
