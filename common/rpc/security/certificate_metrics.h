#pragma once

#include <prometheus/collectable.h>
#include <prometheus/metric_family.h>

#include <utility>
#include <vector>

#include "common/rpc/security/tls_files.h"

namespace slicefarm::rpc {

/// slicefarm_certificate_expiry_timestamp_seconds: when the certificate in this program's files
/// expires; 0 if they cannot be used. Read when asked, as gRPC reads them again while it runs, and
/// of renewed ones that do not fit tells its log only.
class CertificateMetrics : public prometheus::Collectable {
 public:
  /// REQUIRES: files.has_certificate().
  explicit CertificateMetrics(TlsFiles files) : files_(std::move(files)) {}

  std::vector<prometheus::MetricFamily> Collect() const override;

 private:
  const TlsFiles files_;
};

}  // namespace slicefarm::rpc
