#pragma once

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/registry.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "services/coordinator/store/blob_store.h"

namespace slicefarm::coordinator {

/// A store that counts what goes through it:
///   slicefarm_blob_bytes, slicefarm_blobs       what was there when the store was last gone
///   through slicefarm_blob_written_bytes_total          bytes of uploads and results
///   slicefarm_blob_corrupt_total                blobs that were found damaged
class MeteredBlobStore : public BlobStore {
 public:
  /// Both must outlive it.
  MeteredBlobStore(BlobStore& store, prometheus::Registry& registry);

  absl::StatusOr<BlobStatus> Status(const std::string& digest) override {
    return store_.Status(digest);
  }
  absl::StatusOr<BlobStatus> Keep(const std::string& digest) override {
    return store_.Keep(digest);
  }
  absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                    std::string_view bytes) override;
  absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) override {
    return store_.Finish(digest, size);
  }
  absl::StatusOr<std::string> Put(std::string_view bytes) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override;
  absl::StatusOr<std::string> Get(const std::string& digest) override;
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override {
    return store_.Delete(digest, idle_s);
  }
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

 private:
  void Opened(const absl::Status& status);

  BlobStore& store_;
  prometheus::Gauge& bytes_;
  prometheus::Gauge& blobs_;
  prometheus::Counter& written_;
  prometheus::Counter& corrupt_;
};

}  // namespace slicefarm::coordinator
