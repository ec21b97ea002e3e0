#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/blobs/checked_blobs.h"
#include "services/coordinator/store/blobs/name_locks.h"
#include "services/coordinator/store/disk/posix_file.h"

namespace slicefarm::coordinator {

/// Blobs in a directory of this machine:
///
///   blobs/ab/abcd...   complete ones: written elsewhere, fsynced, renamed, the folder fsynced
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
  absl::StatusOr<std::string> PutText(const SpooledText& text) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> Open(const std::string& digest) override;
  absl::StatusOr<std::unique_ptr<BlobReader>> OpenUnchecked(const std::string& digest) override;
  absl::StatusOr<std::string> Get(const std::string& digest) override;
  absl::StatusOr<bool> Delete(const std::string& digest, double idle_s) override;
  absl::StatusOr<int64_t> KeptBytes() override;
  absl::StatusOr<int64_t> DropDamaged(double aside_s) override;
  absl::Status ForEach(const std::function<void(const BlobEntry&)>& visit) override;

 private:
  static constexpr int64_t kUncounted = INT64_MIN / 2;

  explicit DirectoryBlobStore(std::string root) : root_(std::move(root)) {}

  absl::Status RemoveLeftovers() const;
  std::string FolderOf(const std::string& digest) const;
  std::string BlobPath(const std::string& digest) const;
  std::string UploadPath(const std::string& digest) const;
  std::mutex& NameOf(const std::string& digest);
  absl::StatusOr<BlobStatus> StatusNow(const std::string& digest);
  absl::StatusOr<bool> Touch(const std::string& digest);
  absl::Status SyncUpload(const std::string& digest, const PosixFile& file);
  absl::StatusOr<bool> HasGood(const std::string& digest);
  absl::Status Corrupt(const std::string& digest, const std::string& got);
  absl::Status Settle(const std::string& folder);
  absl::Status Complete(const std::string& file, const std::string& digest);
  absl::Status Adopt(const std::string& file, const std::string& digest, int64_t size);

  const std::string root_;
  /// Of blobs: one write to each at a time, however long it takes to hash it and to put it on disk.
  NameLocks writers_;
  /// Held for as long as it takes to look at a file and to rename, touch or remove it: what is kept
  /// is not deleted. Taken after a writer's.
  std::array<std::mutex, 16> names_;
  std::atomic<int64_t> next_tmp_ = 0;
  CheckedBlobs checked_;
  /// What is kept, by what was written and removed since all files were looked at; below 0: they
  /// were not yet. ForEach sets it right again, should two at a time have miscounted.
  std::atomic<int64_t> kept_bytes_ = kUncounted;

  NameLocks folders_;  ///< who makes sure that a folder's names are on disk
  std::mutex doubts_mutex_;
  /// Folders of blobs whose names are on disk for certain. Not so at the start, as an earlier life
  /// may have ended between a rename and its fsync; not so after an fsync that failed.
  std::set<std::string> settled_;
  /// Uploads of which this process wrote all bytes and has not tried to fsync them; others need
  /// PosixFile::SyncAnew.
  std::set<std::string> written_here_;
};

}  // namespace slicefarm::coordinator
