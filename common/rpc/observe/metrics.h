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

/// Metrics of one program, and an HTTP server that provides them to Prometheus (GET /metrics) and
/// HTML pages to people. Built-in metrics: process_cpu_seconds_total,
/// process_resident_memory_bytes, process_open_fds and slicefarm_build_info. Thread-safe.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// Returns the registry, to add metric families. Rules: their names end with a base unit, and no
  /// label is free text.
  prometheus::Registry& registry() { return registry_; }

  /// Adds values that are read whenever Prometheus requests the metrics. Call it before Serve.
  void Show(std::shared_ptr<prometheus::Collectable> values) {
    shown_.push_back(std::move(values));
  }

  /// Adds an HTML page on the same port. Call it before Serve.
  void ShowPage(const std::string& path, std::function<std::string()> html) {
    pages_.push_back({path, "text/html; charset=utf-8", std::move(html)});
  }

  /// Starts the HTTP server on `address` (host:port; port 0: any free port). Returns the port.
  /// Errors: Unavailable if the server cannot listen on this address.
  absl::StatusOr<int> Serve(const std::string& address);

  /// Stops the HTTP server after the running request. Afterwards, the objects that were passed to
  /// Show may be destroyed.
  void Stop();

  /// Returns the text that Prometheus reads.
  std::string Text() const;

 private:
  prometheus::Registry registry_;
  std::vector<std::shared_ptr<prometheus::Collectable>> shown_;  // shared with their creators
  std::vector<HttpPage> pages_;
  std::unique_ptr<HttpPages> server_;
};

}  // namespace slicefarm::rpc
