#include "common/rpc/metrics.h"

#include <prometheus/exposer.h>
#include <prometheus/gauge.h>

#include <exception>

#include "common/model/build_info.h"
#include "common/model/error.h"
#include "common/rpc/process_metrics.h"

namespace slicefarm::rpc {

Metrics::Metrics() : registry_(std::make_shared<prometheus::Registry>()) {
  Show(std::make_shared<ProcessMetrics>());
  prometheus::BuildGauge()
      .Name("slicefarm_build_info")
      .Help("1, with the build as labels")
      .Register(*registry_)
      .Add({{"version", std::string(Version())}, {"build_id", std::string(BuildId())}})
      .Set(1);
}

Metrics::~Metrics() = default;

absl::StatusOr<int> Metrics::Serve(const std::string& address) {
  try {  // the library reports what goes wrong by throwing
    exposer_ = std::make_unique<prometheus::Exposer>(address, /*num_threads=*/1);
    exposer_->RegisterCollectable(registry_);
    for (const auto& values : shown_) exposer_->RegisterCollectable(values);
    return exposer_->GetListeningPorts().at(0);
  } catch (const std::exception& error) {
    return MakeError(absl::StatusCode::kUnavailable, Reason::kUnavailable,
                     "cannot serve metrics on " + address + ": " + error.what());
  }
}

void Metrics::Stop() { exposer_.reset(); }

}  // namespace slicefarm::rpc
