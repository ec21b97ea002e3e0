#include "common/rpc/observe/metrics.h"

#include <prometheus/gauge.h>
#include <prometheus/text_serializer.h>

#include <iterator>
#include <utility>

#include "common/base/build_info.h"
#include "common/rpc/observe/process_metrics.h"

namespace slicefarm::rpc {

Metrics::Metrics() {
  Show(std::make_shared<ProcessMetrics>());
  prometheus::BuildGauge()
      .Name("slicefarm_build_info")
      .Help("1, with the build as labels")
      .Register(registry_)
      .Add({{"version", std::string(Version())}, {"build_id", std::string(BuildId())}})
      .Set(1);
}

Metrics::~Metrics() = default;

std::string Metrics::Text() const {
  std::vector<prometheus::MetricFamily> families = registry_.Collect();
  for (const auto& values : shown_) {
    auto more = values->Collect();
    families.insert(families.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
  }
  return prometheus::TextSerializer().Serialize(families);
}

absl::StatusOr<int> Metrics::Serve(const std::string& address) {
  std::vector<HttpPage> pages = pages_;
  pages.push_back(
      {"/metrics", "text/plain; version=0.0.4; charset=utf-8", [this] { return Text(); }});
  auto server = HttpPages::Serve(address, std::move(pages));
  if (!server.ok()) return server.status();
  server_ = *std::move(server);
  return server_->port();
}

void Metrics::Stop() { server_.reset(); }

}  // namespace slicefarm::rpc
