#include "services/coordinator/store/blobs/directory_blob_store.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/blob_errors.h"
#include "services/coordinator/store/disk/posix_file.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kReadBytes = 1 << 20;

using Lock = std::lock_guard<std::mutex>;

absl::StatusOr<std::string> DigestOf(const PosixFile& file) {
  Sha256 sha;
  for (int64_t offset = 0;;) {
    const auto bytes = file.ReadAt(offset, kReadBytes);
    if (!bytes.ok()) return bytes.status();
    if (bytes->empty()) return sha.Hex();
    sha.Add(*bytes);
    offset += static_cast<int64_t>(bytes->size());
  }
}

/// Returns the seconds since the file was last written or touched; nullopt if it does not exist.
std::optional<double> IdleSeconds(const std::filesystem::path& path) {
  std::error_code gone;
  const auto written = std::filesystem::last_write_time(path, gone);
  if (gone) return std::nullopt;
  const auto now = std::filesystem::file_time_type::clock::now();
  return std::chrono::duration<double>(now - written).count();
}

/// Returns the properties of a file that change when it is written; nullopt if it does not exist.
std::optional<CheckedBlobs::Print> PrintOf(const std::filesystem::path& path) {
  std::error_code error;
  const auto written = std::filesystem::last_write_time(path, error);
  if (error) return std::nullopt;
  const auto size = std::filesystem::file_size(path, error);
  if (error) return std::nullopt;
  const auto since =
      std::chrono::duration_cast<std::chrono::nanoseconds>(written.time_since_epoch());
  return CheckedBlobs::Print{static_cast<int64_t>(size), since.count()};
}

/// Writes the text to a file and to the disk. Returns its digest.
absl::StatusOr<std::string> WriteDurably(const std::string& path, const SpooledText& text) {
  const auto file = PosixFile::OpenToWrite(path);
  if (!file.ok()) return file.status();
  Sha256 sha;
  int64_t offset = 0;
  absl::Status written = text.ForEachBlock([&](std::string_view bytes) {
    sha.Add(bytes);
    const int64_t at = std::exchange(offset, offset + std::ssize(bytes));
    return file->WriteAt(at, bytes);
  });
  if (written.ok()) written = file->Sync();
  if (!written.ok()) return written;
  return sha.Hex();
}

class FileReader : public BlobReader {
 public:
  FileReader(PosixFile file, int64_t size) : file_(std::move(file)), size_(size) {}
  int64_t size() const override { return size_; }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override {
    return file_.ReadAt(offset, count);
  }

  PosixFile file_;
  int64_t size_;
};

absl::Status ListError(const std::string& path, const std::error_code& error) {
  return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                   absl::StrCat("list ", path, ": ", error.message()));
}

absl::StatusOr<PosixFile> OpenBlob(const std::string& path, const std::string& digest) {
  auto file = PosixFile::OpenToRead(path);
  if (!absl::IsNotFound(file.status())) return file;
  return BlobNotFound(digest);
}

}  // namespace

absl::StatusOr<std::unique_ptr<DirectoryBlobStore>> DirectoryBlobStore::OpenAt(
    const std::string& root) {
  for (const char* part : {"/blobs", "/uploads", "/tmp", "/corrupt"}) {
    if (absl::Status made = MakeDirectory(root + part); !made.ok()) return made;
  }
  std::unique_ptr<DirectoryBlobStore> store(new DirectoryBlobStore(root));
  if (absl::Status removed = store->RemoveLeftovers(); !removed.ok()) return removed;
  return store;
}

/// Removes unfinished files of the previous run of the program, and uploads of blobs that are
/// complete.
absl::Status DirectoryBlobStore::RemoveLeftovers() const {
  namespace fs = std::filesystem;
  for (const auto& [part, all] : {std::pair("/tmp", true), std::pair("/uploads", false)}) {
    std::error_code error;
    fs::directory_iterator files(root_ + part, error);
    for (; !error && files != fs::directory_iterator(); files.increment(error)) {
      if (!all && !fs::exists(BlobPath(files->path().filename()), error)) continue;
      if (absl::Status removed = RemoveFile(files->path()); !removed.ok()) return removed;
    }
    if (error) return ListError(root_ + part, error);
  }
  return absl::OkStatus();
}

std::string DirectoryBlobStore::FolderOf(const std::string& digest) const {
  return absl::StrCat(root_, "/blobs/", digest.substr(0, 2));
}

std::string DirectoryBlobStore::BlobPath(const std::string& digest) const {
  return absl::StrCat(FolderOf(digest), "/", digest);
}

std::string DirectoryBlobStore::UploadPath(const std::string& digest) const {
  return absl::StrCat(root_, "/uploads/", digest);
}

std::mutex& DirectoryBlobStore::NameOf(const std::string& digest) {
  return names_[std::hash<std::string>()(digest) % names_.size()];
}

/// Returns the current status. The size of an upload may include bytes that are being written.
absl::StatusOr<BlobStatus> DirectoryBlobStore::StatusNow(const std::string& digest) {
  // The blob is checked again at the end, because an upload may become a blob between the first two
  // checks.
  for (const bool complete : {true, false, true}) {
    const auto file = PosixFile::OpenToRead(complete ? BlobPath(digest) : UploadPath(digest));
    if (absl::IsNotFound(file.status())) continue;
    if (!file.ok()) return file.status();
    const auto size = file->Size();
    if (!size.ok()) return size.status();
    if (complete) {
      if (absl::Status synced = SyncFolder(FolderOf(digest)); !synced.ok()) return synced;
    }
    return BlobStatus{*size, complete};
  }
  return BlobStatus{};
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Status(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  return StatusNow(digest);
}

/// Marks the blob as used now. Returns false if it does not exist. A checked blob remains checked,
/// because only its date changes.
absl::StatusOr<bool> DirectoryBlobStore::Touch(const std::string& digest) {
  const std::string path = BlobPath(digest);
  Lock lock(NameOf(digest));
  const auto before = PrintOf(path);
  if (!before) return false;
  const bool checked = checked_.Holds(digest, *before);
  if (absl::Status touched = TouchFile(path); !touched.ok()) return touched;
  const auto after = PrintOf(path);
  if (checked && after && after->size == before->size) checked_.Add(digest, *after);
  return true;
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Append(const std::string& digest, int64_t offset,
                                                      std::string_view bytes) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto writing = writers_.Take(digest);
  auto status = StatusNow(digest);
  if (!status.ok() || status->complete) return status;
  const int64_t committed = status->committed_size;
  if (offset < 0 || offset > committed) return UploadOffset(digest, committed, offset);
  const auto known = std::min<int64_t>(committed - offset, static_cast<int64_t>(bytes.size()));
  bytes.remove_prefix(known);
  if (bytes.empty()) return status;
  const auto file = PosixFile::OpenToWrite(UploadPath(digest));
  if (!file.ok()) return file.status();
  if (absl::Status written = file->WriteAt(committed, bytes); !written.ok()) {
    file->Truncate(committed).IgnoreError();
    return written;
  }
  if (committed == 0) {
    Lock doubts(doubts_mutex_);
    written_here_.insert(digest);
  }
  status->committed_size += static_cast<int64_t>(bytes.size());
  kept_bytes_ += static_cast<int64_t>(bytes.size());
  return status;
}

/// Creates the folder if it does not exist. Afterwards, all names that the folder had before are on
/// disk.
absl::Status DirectoryBlobStore::SyncFolder(const std::string& folder) {
  const auto is_synced = [&] {
    Lock lock(doubts_mutex_);
    return synced_folders_.contains(folder);
  };
  if (is_synced()) return absl::OkStatus();
  const auto making = folders_.Take(folder);
  if (is_synced()) return absl::OkStatus();
  if (absl::Status made = MakeDirectory(folder); !made.ok()) return made;
  if (absl::Status synced = SyncDirectory(folder); !synced.ok()) return synced;
  Lock lock(doubts_mutex_);
  synced_folders_.insert(folder);
  return absl::OkStatus();
}

/// Makes the file the blob by renaming it. REQUIRES: the bytes of the file are on disk.
absl::Status DirectoryBlobStore::Complete(const std::string& file, const std::string& digest) {
  const std::string folder = FolderOf(digest);
  if (absl::Status synced = SyncFolder(folder); !synced.ok()) return synced;
  {
    Lock lock(NameOf(digest));
    if (absl::Status renamed = RenameFile(file, BlobPath(digest)); !renamed.ok()) return renamed;
  }
  absl::Status synced = SyncDirectory(folder);
  if (!synced.ok()) {
    // Waits for threads that call fsync for the folder without knowing this name.
    const auto making = folders_.Take(folder);
    Lock lock(doubts_mutex_);
    synced_folders_.erase(folder);
  }
  return synced;
}

absl::Status DirectoryBlobStore::SyncUpload(const std::string& digest, const PosixFile& file) {
  const bool dirty = [&] {
    Lock lock(doubts_mutex_);
    return written_here_.erase(digest) > 0;
  }();
  return dirty ? file.Sync() : file.SyncAnew();
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Finish(const std::string& digest, int64_t size) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto writing = writers_.Take(digest);
  const auto status = StatusNow(digest);
  if (!status.ok()) return status;
  if (status->complete) {
    const auto touched = Touch(digest);
    if (!touched.ok()) return touched.status();
    return status;
  }
  if (status->committed_size < size) return UploadOffset(digest, status->committed_size, size);
  const std::string path = UploadPath(digest);
  const auto file = PosixFile::OpenToWrite(path);  // also creates the file of an empty blob
  if (!file.ok()) return file.status();
  const auto got = DigestOf(*file);
  if (!got.ok()) return got.status();
  if (*got != digest) {
    if (absl::Status removed = RemoveFile(path); !removed.ok()) return removed;
    kept_bytes_ -= status->committed_size;
    Lock doubts(doubts_mutex_);
    written_here_.erase(digest);
    return BlobMismatch(absl::StatusCode::kInvalidArgument, digest, *got);
  }
  if (absl::Status synced = SyncUpload(digest, *file); !synced.ok()) return synced;
  if (absl::Status done = Complete(path, digest); !done.ok()) return done;
  return BlobStatus{status->committed_size, /*complete=*/true};
}

/// Returns true if the blob exists undamaged, and marks it as used. If false, an unreadable blob
/// must be replaced.
absl::StatusOr<bool> DirectoryBlobStore::HasGood(const std::string& digest) {
  const auto file = PosixFile::OpenToRead(BlobPath(digest));
  if (!file.ok()) return false;
  const auto got = DigestOf(*file);
  if (!got.ok() || *got != digest) return false;
  if (absl::Status synced = SyncFolder(FolderOf(digest)); !synced.ok()) return synced;
  return Touch(digest);
}

/// Makes the file the blob, unless the blob exists. REQUIRES: the bytes of the file are on disk.
absl::Status DirectoryBlobStore::Adopt(const std::string& file, const std::string& digest,
                                       int64_t size) {
  const auto writing = writers_.Take(digest);
  const auto here = HasGood(digest);
  if (!here.ok()) return here.status();
  if (*here) return RemoveFile(file);
  absl::Status completed = Complete(file, digest);
  if (completed.ok()) kept_bytes_ += size;
  return completed;
}

absl::StatusOr<std::string> DirectoryBlobStore::PutText(const SpooledText& text) {
  const std::string path = absl::StrCat(root_, "/tmp/", next_tmp_++);
  const auto digest = WriteDurably(path, text);
  const absl::Status kept = digest.ok() ? Adopt(path, *digest, text.size()) : digest.status();
  if (kept.ok()) return digest;
  RemoveFile(path).IgnoreError();
  return kept;
}

/// Puts a damaged blob aside, unless it was replaced by a good one after it was read.
absl::Status DirectoryBlobStore::Corrupt(const std::string& digest, const std::string& got) {
  const auto writing = writers_.Take(digest);
  const auto file = OpenBlob(BlobPath(digest), digest);
  if (absl::IsNotFound(file.status()))
    return BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
  if (!file.ok()) return file.status();
  const auto now = DigestOf(*file);
  if (!now.ok()) return now.status();
  if (*now != digest) {
    const std::string aside = absl::StrCat(root_, "/corrupt/", digest);
    // After half of a rename and a power cut, both names may be the same file. A rename would then
    // do nothing.
    if (absl::Status removed = RemoveFile(aside); !removed.ok()) return removed;
    Lock lock(NameOf(digest));
    if (absl::Status moved = RenameFile(BlobPath(digest), aside); !moved.ok()) return moved;
    TouchFile(aside).IgnoreError();  // the damaged blob is kept for a time that begins now
  }
  return BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
}

absl::StatusOr<std::unique_ptr<BlobReader>> DirectoryBlobStore::Open(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  auto file = OpenBlob(BlobPath(digest), digest);
  if (!file.ok()) return file.status();
  const auto print = PrintOf(BlobPath(digest));
  if (!print || !checked_.Holds(digest, *print)) {
    const auto got = DigestOf(*file);
    if (!got.ok()) return got.status();
    if (*got != digest) return Corrupt(digest, *got);
    if (print) checked_.Add(digest, *print);
  }
  const auto size = file->Size();
  if (!size.ok()) return size.status();
  return std::make_unique<FileReader>(*std::move(file), *size);
}

absl::StatusOr<std::unique_ptr<BlobReader>> DirectoryBlobStore::OpenUnchecked(
    const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  auto file = OpenBlob(BlobPath(digest), digest);
  if (!file.ok()) return file.status();
  const auto size = file->Size();
  if (!size.ok()) return size.status();
  return std::make_unique<FileReader>(*std::move(file), *size);
}

absl::StatusOr<std::string> DirectoryBlobStore::Get(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto file = OpenBlob(BlobPath(digest), digest);
  if (!file.ok()) return file.status();
  const auto size = file->Size();
  if (!size.ok()) return size.status();
  auto bytes = file->ReadAt(0, *size);
  if (!bytes.ok()) return bytes.status();
  const std::string got = Sha256Hex(*bytes);
  if (got != digest) return Corrupt(digest, got);
  return bytes;
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Keep(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto status = StatusNow(digest);
  if (!status.ok() || !status->complete) return status;
  const auto touched = Touch(digest);
  if (!touched.ok()) return touched.status();
  return *touched ? status : StatusNow(digest);
}

absl::StatusOr<bool> DirectoryBlobStore::Delete(const std::string& digest, double idle_s) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto writing = writers_.TryTake(digest);
  if (!writing) return false;  // the blob is in use
  Lock lock(NameOf(digest));
  bool deleted = false;
  for (const std::string& path : {BlobPath(digest), UploadPath(digest)}) {
    const auto idle = IdleSeconds(path);
    if (!idle || *idle < idle_s) continue;
    std::error_code gone;
    const auto size = std::filesystem::file_size(path, gone);
    if (absl::Status removed = RemoveFile(path); !removed.ok()) return removed;
    if (!gone) kept_bytes_ -= static_cast<int64_t>(size);
    deleted = true;
  }
  if (deleted) {
    Lock doubts(doubts_mutex_);
    written_here_.erase(digest);
  }
  return deleted;
}

absl::StatusOr<int64_t> DirectoryBlobStore::KeptBytes() {
  if (const int64_t kept = kept_bytes_; kept >= 0) return kept;
  if (absl::Status counted = ForEach([](const BlobEntry&) {}); !counted.ok()) return counted;
  return std::max<int64_t>(0, kept_bytes_);
}

absl::StatusOr<int64_t> DirectoryBlobStore::DropDamaged(double aside_s) {
  namespace fs = std::filesystem;
  int64_t bytes = 0;
  std::error_code error;
  fs::directory_iterator files(root_ + "/corrupt", error);
  for (; !error && files != fs::directory_iterator(); files.increment(error)) {
    std::error_code gone;
    const auto size = static_cast<int64_t>(files->file_size(gone));
    const auto idle = IdleSeconds(files->path());
    if (gone || !idle || *idle < aside_s) continue;
    if (absl::Status removed = RemoveFile(files->path()); !removed.ok()) return removed;
    bytes += size;
  }
  if (error) return ListError(root_ + "/corrupt", error);
  return bytes;
}

absl::Status DirectoryBlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  namespace fs = std::filesystem;
  int64_t bytes = 0;
  for (const bool complete : {true, false}) {
    std::error_code error;
    fs::recursive_directory_iterator files(root_ + (complete ? "/blobs" : "/uploads"), error);
    for (; !error && files != fs::recursive_directory_iterator(); files.increment(error)) {
      std::error_code gone;
      BlobEntry entry{files->path().filename(), 0, complete, 0};
      if (!files->is_regular_file(gone) || !IsSha256Hex(entry.digest)) continue;
      entry.size = static_cast<int64_t>(files->file_size(gone));
      const auto idle = IdleSeconds(files->path());
      if (gone || !idle) continue;
      entry.idle_s = *idle;
      bytes += entry.size;
      visit(entry);
    }
    if (error) return ListError(root_, error);
  }
  kept_bytes_ = bytes;
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
