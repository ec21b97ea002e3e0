#include "services/coordinator/server/metered_blob_store.h"

namespace slicefarm::coordinator {
namespace {

prometheus::Gauge& Gauge(prometheus::Registry& registry, const std::string& name,
                         const std::string& help) {
  return prometheus::BuildGauge().Name(name).Help(help).Register(registry).Add({});
}

prometheus::Counter& Counter(prometheus::Registry& registry, const std::string& name,
                             const std::string& help) {
  return prometheus::BuildCounter().Name(name).Help(help).Register(registry).Add({});
}

}  // namespace

MeteredBlobStore::MeteredBlobStore(BlobStore& store, prometheus::Registry& registry)
    : store_(store),
      bytes_(Gauge(registry, "slicefarm_blob_bytes",
                   "Bytes of blobs and uploads when the store was last swept")),
      blobs_(Gauge(registry, "slicefarm_blobs", "Blobs and uploads when the store was last swept")),
      written_(Counter(registry, "slicefarm_blob_written_bytes_total",
                       "Bytes of uploads and results that were written")),
      corrupt_(Counter(registry, "slicefarm_blob_corrupt_total",
                       "Blobs whose bytes were found to be others than their name says")) {}

absl::StatusOr<BlobStatus> MeteredBlobStore::Append(const std::string& digest, int64_t offset,
                                                    std::string_view bytes) {
  auto status = store_.Append(digest, offset, bytes);
  if (status.ok()) written_.Increment(static_cast<double>(bytes.size()));
  return status;
}

absl::StatusOr<std::string> MeteredBlobStore::Put(std::string_view bytes) {
  auto digest = store_.Put(bytes);
  if (digest.ok()) written_.Increment(static_cast<double>(bytes.size()));
  return digest;
}

absl::StatusOr<std::unique_ptr<BlobReader>> MeteredBlobStore::Open(const std::string& digest) {
  auto reader = store_.Open(digest);
  Opened(reader.status());
  return reader;
}

absl::StatusOr<std::string> MeteredBlobStore::Get(const std::string& digest) {
  auto bytes = store_.Get(digest);
  Opened(bytes.status());
  return bytes;
}

absl::Status MeteredBlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  double blobs = 0;
  double bytes = 0;
  absl::Status status = store_.ForEach([&](const BlobEntry& entry) {
    ++blobs;
    bytes += static_cast<double>(entry.size);
    visit(entry);
  });
  if (!status.ok()) return status;
  blobs_.Set(blobs);
  bytes_.Set(bytes);
  return status;
}

void MeteredBlobStore::Opened(const absl::Status& status) {
  if (absl::IsDataLoss(status)) corrupt_.Increment();
}

}  // namespace slicefarm::coordinator
