#pragma once

#include <memory>
#include <string>

#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/blobs/checked_blobs.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Blobs of a tenant in the tables `blobs` and `blob_pieces` of `deploy/postgres`. Several
/// coordinators may share them. Damaged blobs have the name `corrupt/DIGEST`. If the database is
/// killed, the last bytes of an upload may be lost, but a complete blob is on disk.
class PostgresBlobStore : public BlobStore {
 public:
  explicit PostgresBlobStore(std::shared_ptr<SqlDatabase> database, std::string tenant = "")
      : database_(std::move(database)), tenant_(std::move(tenant)) {}

  absl::StatusOr<BlobStatus> Status(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Keep(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                    std::string_view bytes) override;
  absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) override;
  absl::StatusOr<std::string> PutText(const SpooledText& text) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) override;
  absl::StatusOr<std::string> Get(const std::string& digest) override;
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override;
  absl::StatusOr<int64_t> KeptBytes() override;
  absl::StatusOr<int64_t> DropDamaged(double aside_s) override;
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

 private:
  absl::StatusOr<int64_t> Check(const std::string& digest, std::string* bytes);
  absl::Status Corrupt(const std::string& digest, const std::string& got);

  const std::shared_ptr<SqlDatabase> database_;  // shared with the readers that it returned
  const std::string tenant_;
  CheckedBlobs checked_;
};

}  // namespace slicefarm::coordinator
