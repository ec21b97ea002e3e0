#pragma once

#include <memory>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "prometheus/registry.h"

namespace prometheus {
class Exposer;
}

namespace slicefarm::rpc {

/// The metrics of one process and the port that shows them to Prometheus (GET /metrics). Its own:
/// process_cpu_seconds_total, process_resident_memory_bytes, process_open_fds and
/// slicefarm_build_info. Thread-safe.
class Metrics {
 public:
  Metrics();
  ~Metrics();
  Metrics(const Metrics&) = delete;
  Metrics& operator=(const Metrics&) = delete;

  /// For families of one's own. Units stand in the name, base units, no label of free text.
  prometheus::Registry& registry() { return *registry_; }

  /// Shows values that are looked up when Prometheus asks. Before Serve.
  void Show(std::shared_ptr<prometheus::Collectable> values) {
    shown_.push_back(std::move(values));
  }

  /// Serves on `address` (host:port, port 0: any); returns the port. Errors: Unavailable if it
  /// cannot listen there.
  absl::StatusOr<int> Serve(const std::string& address);

  /// Waits for a scrape that is being answered, and serves no more: what is shown may go.
  void Stop();

 private:
  // Shared with the exposer, which holds them weakly.
  std::shared_ptr<prometheus::Registry> registry_;
  std::vector<std::shared_ptr<prometheus::Collectable>> shown_;
  std::unique_ptr<prometheus::Exposer> exposer_;
};

}  // namespace slicefarm::rpc
