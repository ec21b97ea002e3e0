#include "services/coordinator/server/observe/metered_blob_store.h"

#include <functional>
#include <string_view>
#include <utility>

namespace slicefarm::coordinator {
namespace {

prometheus::Gauge& Gauge(prometheus::Registry& registry, const std::string& name,
                         const std::string& help) {
  return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
}

prometheus::Counter& OneCounter(prometheus::Registry& registry, const std::string& name,
                                const std::string& help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry).Add({});
}

}  // namespace

/// Metered blob store of one tenant.
class MeteredBlobStores::Metered : public BlobStore {
 public:
  Metered(MeteredBlobStores& all, std::string tenant, std::shared_ptr<BlobStore> store)
      : all_(all), tenant_(std::move(tenant)), store_(std::move(store)) {}

  absl::StatusOr<BlobStatus> Status(const std::string& digest) override {
    return store_->Status(digest);
  }
  absl::StatusOr<BlobStatus> Keep(const std::string& digest) override {
    return store_->Keep(digest);
  }
  absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                    std::string_view bytes) override {
    return Written(store_->Append(digest, offset, bytes), std::ssize(bytes));
  }
  absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) override {
    return store_->Finish(digest, size);
  }
  absl::StatusOr<std::string> PutText(const SpooledText& text) override {
    return Written(store_->PutText(text), text.size());
  }
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override {
    return Opened(store_->Open(digest));
  }
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) override {
    return store_->OpenUnchecked(digest);
  }
  absl::StatusOr<std::string> Get(const std::string& digest) override {
    return Opened(store_->Get(digest));
  }
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override {
    return store_->Delete(digest, idle_s);
  }
  absl::StatusOr<int64_t> KeptBytes() override { return store_->KeptBytes(); }
  absl::StatusOr<int64_t> DropDamaged(double aside_s) override {
    return store_->DropDamaged(aside_s);
  }
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override {
    Content content;
    absl::Status status = store_->ForEach([&](const BlobEntry& entry) {
      ++content.blobs;
      content.bytes += static_cast<double>(entry.size);
      visit(entry);
    });
    if (status.ok()) all_.Found(tenant_, content);
    return status;
  }

 private:
  template <typename Result>
  Result Written(Result result, int64_t bytes) {
    if (result.ok()) all_.written_.Increment(static_cast<double>(bytes));
    return result;
  }
  template <typename Result>
  Result Opened(Result result) {
    if (absl::IsDataLoss(result.status())) all_.corrupt_.Increment();
    return result;
  }

  MeteredBlobStores& all_;
  const std::string tenant_;
  const std::shared_ptr<BlobStore> store_;  // wrapped store, from BlobStores
};

MeteredBlobStores::MeteredBlobStores(BlobStores& stores, prometheus::Registry& registry)
    : stores_(stores),
      bytes_(Gauge(registry, "slicefarm_blob_bytes",
                   "Bytes of blobs and uploads when the store was last swept")),
      blobs_(Gauge(registry, "slicefarm_blobs", "Blobs and uploads when the store was last swept")),
      written_(OneCounter(registry, "slicefarm_blob_written_bytes_total",
                          "Bytes of written uploads and results")),
      corrupt_(OneCounter(registry, "slicefarm_blob_corrupt_total",
                          "Blobs with bytes that differ from their digest")) {}

absl::StatusOr<std::shared_ptr<BlobStore>> MeteredBlobStores::Of(const std::string& tenant) {
  auto store = stores_.Of(tenant);
  if (!store.ok()) return store.status();
  return std::make_shared<Metered>(*this, tenant, *std::move(store));
}

void MeteredBlobStores::Found(const std::string& tenant, const Content& content) {
  const std::lock_guard lock(mutex_);
  contents_[tenant] = content;
  Content all;
  for (const auto& [name, found] : contents_) {
    all.blobs += found.blobs;
    all.bytes += found.bytes;
  }
  blobs_.Set(all.blobs);
  bytes_.Set(all.bytes);
}

}  // namespace slicefarm::coordinator
