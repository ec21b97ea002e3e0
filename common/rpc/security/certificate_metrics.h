#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <utility>
#include <vector>

#include "common/rpc/security/tls_files.h"

namespace slicefarm::rpc {

/// Metric slicefarm_certificate_expiry_timestamp_seconds: expiry time of the certificate in this
/// program's files; 0 if the files cannot be used. The files are read for each request of the
/// metrics. gRPC also reads renewed files while it runs; if they are unusable, only gRPC's log
/// shows this.
class CertificateMetrics : public prometheus::Collectable {
 public:
  /// REQUIRES: files.has_certificate().
  explicit CertificateMetrics(TlsFiles files) : files_(std::move(files)) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  const TlsFiles files_;
};

}  // namespace slicefarm::rpc
