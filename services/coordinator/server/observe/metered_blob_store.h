#pragma once

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/registry.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "services/coordinator/store/blobs/blob_stores.h"

namespace slicefarm::coordinator {

/// Blob stores that count their content and their writes, over all tenants:
///   slicefarm_blob_bytes, slicefarm_blobs   content at the last complete listing of each store;
///   slicefarm_blob_written_bytes_total      bytes of uploads and results;
///   slicefarm_blob_corrupt_total            blobs that were found damaged.
class MeteredBlobStores : public BlobStores {
 public:
  /// Wraps `stores`. `stores` and `registry` must outlive this object and the stores that it
  /// returns.
  MeteredBlobStores(BlobStores& stores, prometheus::Registry& registry);

  absl::StatusOr<std::shared_ptr<BlobStore>> Of(const std::string& tenant) override;
  absl::StatusOr<std::vector<std::string>> Tenants() override { return stores_.Tenants(); }

 private:
  class Metered;
  struct Content {
    double blobs = 0;
    double bytes = 0;
  };

  void Found(const std::string& tenant, const Content& content);

  BlobStores& stores_;
  prometheus::Gauge& bytes_;
  prometheus::Gauge& blobs_;
  prometheus::Counter& written_;
  prometheus::Counter& corrupt_;
  std::mutex mutex_;
  std::map<std::string, Content> contents_;  ///< content by tenant
};

}  // namespace slicefarm::coordinator
