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

/// Blob store in a local directory:
///
///   blobs/ab/abcd...   complete blobs; written in uploads/ or tmp/, fsynced and renamed, then the
///                      folder is fsynced;
///   uploads/abcd...    incomplete uploads;
///   tmp/               files that Put is writing; emptied at the start;
///   corrupt/abcd...    blobs with changed bytes, moved so that a new upload can use the name.
class DirectoryBlobStore : public BlobStore {
 public:
  /// Opens the store in a directory, which is created if it does not exist. REQUIRES: no other
  /// program uses the directory.
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
  absl::Status SyncFolder(const std::string& folder);
  absl::Status Complete(const std::string& file, const std::string& digest);
  absl::Status Adopt(const std::string& file, const std::string& digest, int64_t size);

  const std::string root_;
  /// Locks by digest. Only one thread at a time writes a blob, hashes it or calls fsync for it.
  NameLocks writers_;
  /// Locks by digest for short steps: from the check of a file to its rename, touch or removal. So
  /// a blob that Keep marks as used is not deleted at the same time. Taken after the lock in
  /// `writers_`.
  std::array<std::mutex, 16> names_;
  std::atomic<int64_t> next_tmp_ = 0;
  CheckedBlobs checked_;
  /// Total size of the store, updated by each write and removal since the last listing of all
  /// files. Below 0: there was no listing yet. ForEach corrects the value, because concurrent calls
  /// may have counted wrongly.
  std::atomic<int64_t> kept_bytes_ = kUncounted;

  NameLocks folders_;  ///< locks by folder, for the fsync of a folder of blobs
  std::mutex doubts_mutex_;
  /// Folders of blobs with all their file names on disk. At the start the set is empty, because the
  /// program may have ended earlier between a rename and the fsync of its folder. After a failed
  /// fsync, the folder is removed from the set.
  std::set<std::string> synced_folders_;
  /// Uploads that only this program has written and for which it has not called fsync yet. All
  /// other uploads need PosixFile::SyncAnew.
  std::set<std::string> written_here_;
};

}  // namespace slicefarm::coordinator
