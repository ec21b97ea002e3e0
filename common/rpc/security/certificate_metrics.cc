#include "common/rpc/security/certificate_metrics.h"

namespace slicefarm::rpc {

std::vector<prometheus::MetricFamily> CertificateMetrics::Collect() const {
  prometheus::ClientMetric expiry;
  expiry.gauge.value = static_cast<double>(CertificateExpiry(files_).value_or(0));
  return {{"slicefarm_certificate_expiry_timestamp_seconds",
           "Time at which the certificate in this program's files expires; 0: it cannot be used",
           prometheus::MetricType::Gauge,
           {expiry}}};
}

}  // namespace slicefarm::rpc
