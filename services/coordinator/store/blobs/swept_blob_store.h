#pragma once

#include <memory>
#include <string>

#include "services/coordinator/store/blobs/blob_store.h"

namespace slicefarm::coordinator {

/// Base class of blob stores for tests of the sweep. Calls that a sweep does not make return
/// errors.
class SweptBlobStore : public BlobStore {
 public:
  absl::StatusOr<int64_t> KeptBytes() override { return Unused(); }
  absl::StatusOr<int64_t> DropDamaged(double) override { return 0; }
  absl::StatusOr<BlobStatus> Status(const std::string&) override { return Unused(); }
  absl::StatusOr<BlobStatus> Keep(const std::string&) override { return Unused(); }
  absl::StatusOr<BlobStatus> Append(const std::string&, int64_t, std::string_view) override {
    return Unused();
  }
  absl::StatusOr<BlobStatus> Finish(const std::string&, int64_t) override { return Unused(); }
  absl::StatusOr<std::string> PutText(const SpooledText&) override { return Unused(); }
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string&) override { return Unused(); }
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string&) override {
    return Unused();
  }
  absl::StatusOr<std::string> Get(const std::string&) override { return Unused(); }

 private:
  static absl::Status Unused() { return absl::UnimplementedError("no sweep calls it"); }
};

}  // namespace slicefarm::coordinator
