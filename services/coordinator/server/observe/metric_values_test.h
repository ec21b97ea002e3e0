#pragma once

#include <prometheus/registry.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace slicefarm::coordinator {

/// Returns the value of a metric, for tests. For a histogram, returns its number of observations.
/// Returns nullopt if the metric does not exist.
inline std::optional<double> MetricValue(const std::vector<prometheus::MetricFamily>& families,
                                         const std::string& name,
                                         const std::map<std::string, std::string>& labels = {}) {
  for (const auto& family : families) {
    if (family.name != name) continue;
    for (const auto& metric : family.metric) {
      std::map<std::string, std::string> have;
      for (const auto& label : metric.label) have[label.name] = label.value;
      if (have != labels) continue;
      if (family.type == prometheus::MetricType::Histogram) {
        return static_cast<double>(metric.histogram.sample_count);
      }
      return family.type == prometheus::MetricType::Counter ? metric.counter.value
                                                            : metric.gauge.value;
    }
  }
  return std::nullopt;
}

}  // namespace slicefarm::coordinator
