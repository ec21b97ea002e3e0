#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <string>

#include "services/coordinator/store/blob_store.h"

namespace slicefarm::coordinator {

/// Blobs in a directory of this machine:
///
///   blobs/ab/abcd...   complete ones: written elsewhere, fsynced, renamed, the directory fsynced
///   uploads/abcd...    what came of an upload so far
///   tmp/               what Put is writing; emptied at the start
///   corrupt/abcd...    blobs whose bytes had changed when they were read: out of the way of a new
///   upload
class DirectoryBlobStore : public BlobStore {
 public:
  /// Makes the directory if need be. REQUIRES: no other process uses it.
  static absl::StatusOr<std::unique_ptr<DirectoryBlobStore>> OpenAt(const std::string& root);

  absl::StatusOr<BlobStatus> Status(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Keep(const std::string& digest) override;
  absl::StatusOr<BlobStatus> Append(const std::string& digest, int64_t offset,
                                    std::string_view bytes) override;
  absl::StatusOr<BlobStatus> Finish(const std::string& digest, int64_t size) override;
  absl::StatusOr<std::string> Put(std::string_view bytes) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override;
  absl::StatusOr<std::string> Get(const std::string& digest) override;
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override;
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

 private:
  explicit DirectoryBlobStore(std::string root) : root_(std::move(root)) {}

  std::string BlobPath(const std::string& digest) const;
  std::string UploadPath(const std::string& digest) const;
  std::mutex& MutexOf(const std::string& digest);
  absl::StatusOr<BlobStatus> StatusLocked(const std::string& digest) const;
  absl::Status Corrupt(const std::string& digest, const std::string& got);
  absl::Status Complete(const std::string& file, const std::string& digest) const;

  const std::string root_;
  std::array<std::mutex, 16> mutexes_;  ///< one write to a blob at a time
  std::atomic<int64_t> next_tmp_ = 0;
};

}  // namespace slicefarm::coordinator
