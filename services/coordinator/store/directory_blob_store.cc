#include "services/coordinator/store/directory_blob_store.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/model/error.h"
#include "common/model/sha256.h"
#include "services/coordinator/store/blob_errors.h"
#include "services/coordinator/store/posix_file.h"

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

/// So that it counts as new for what removes old blobs.
void Touch(const std::string& path) {
  std::error_code ignored;  // a blob that is taken for older than it is, at worst
  std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now(), ignored);
}

/// Since the file was last written or touched; none if it is not there.
std::optional<double> IdleSeconds(const std::filesystem::path& path) {
  std::error_code gone;
  const auto written = std::filesystem::last_write_time(path, gone);
  if (gone) return std::nullopt;
  const auto now = std::filesystem::file_time_type::clock::now();
  return std::chrono::duration<double>(now - written).count();
}

class FileReader : public BlobReader {
 public:
  FileReader(PosixFile file, int64_t size) : file_(std::move(file)), size_(size) {}
  int64_t size() const override { return size_; }
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit) override {
    return file_.ReadAt(offset, std::clamp<int64_t>(size_ - offset, 0, limit));
  }

 private:
  PosixFile file_;
  int64_t size_;
};

absl::StatusOr<PosixFile> OpenBlob(const std::string& path, const std::string& digest) {
  auto file = PosixFile::OpenToRead(path);
  if (!absl::IsNotFound(file.status())) return file;
  return BlobNotFound(digest);
}

}  // namespace

absl::StatusOr<std::unique_ptr<DirectoryBlobStore>> DirectoryBlobStore::OpenAt(
    const std::string& root) {
  std::error_code ignored;  // what was being written when the last process ended
  std::filesystem::remove_all(root + "/tmp", ignored);
  for (const char* part : {"/blobs", "/uploads", "/tmp", "/corrupt"}) {
    if (absl::Status made = MakeDirectory(root + part); !made.ok()) return made;
  }
  return std::unique_ptr<DirectoryBlobStore>(new DirectoryBlobStore(root));
}

std::string DirectoryBlobStore::BlobPath(const std::string& digest) const {
  return absl::StrCat(root_, "/blobs/", digest.substr(0, 2), "/", digest);
}

std::string DirectoryBlobStore::UploadPath(const std::string& digest) const {
  return absl::StrCat(root_, "/uploads/", digest);
}

std::mutex& DirectoryBlobStore::MutexOf(const std::string& digest) {
  return mutexes_[std::hash<std::string>()(digest) % mutexes_.size()];
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::StatusLocked(const std::string& digest) const {
  for (const bool complete : {true, false}) {
    const auto file = PosixFile::OpenToRead(complete ? BlobPath(digest) : UploadPath(digest));
    if (absl::IsNotFound(file.status())) continue;
    if (!file.ok()) return file.status();
    const auto size = file->Size();
    if (!size.ok()) return size.status();
    return BlobStatus{*size, complete};
  }
  return BlobStatus{};
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Status(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  Lock lock(MutexOf(digest));
  return StatusLocked(digest);
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Append(const std::string& digest, int64_t offset,
                                                      std::string_view bytes) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  Lock lock(MutexOf(digest));
  auto status = StatusLocked(digest);
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
  status->committed_size += static_cast<int64_t>(bytes.size());
  return status;
}

/// The file becomes the blob: durable first, and under its name then.
absl::Status DirectoryBlobStore::Complete(const std::string& path,
                                          const std::string& digest) const {
  const auto file = PosixFile::OpenToWrite(path);
  if (!file.ok()) return file.status();
  if (absl::Status synced = file->Sync(); !synced.ok()) return synced;
  const std::string target = BlobPath(digest);
  const std::string folder = std::filesystem::path(target).parent_path();
  if (absl::Status made = MakeDirectory(folder); !made.ok()) return made;
  return RenameDurably(path, target);
}

absl::StatusOr<BlobStatus> DirectoryBlobStore::Finish(const std::string& digest, int64_t size) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  Lock lock(MutexOf(digest));
  const auto status = StatusLocked(digest);
  if (status.ok() && status->complete) Touch(BlobPath(digest));
  if (!status.ok() || status->complete) return status;
  if (status->committed_size < size) return UploadOffset(digest, status->committed_size, size);
  const std::string path = UploadPath(digest);
  const auto file = PosixFile::OpenToWrite(path);  // also makes the file of an empty blob
  if (!file.ok()) return file.status();
  const auto got = DigestOf(*file);
  if (!got.ok()) return got.status();
  if (*got != digest) {
    if (absl::Status removed = RemoveFile(path); !removed.ok()) return removed;
    return BlobMismatch(absl::StatusCode::kInvalidArgument, digest, *got);
  }
  if (absl::Status done = Complete(path, digest); !done.ok()) return done;
  return BlobStatus{status->committed_size, /*complete=*/true};
}

absl::StatusOr<std::string> DirectoryBlobStore::Put(std::string_view bytes) {
  const std::string digest = Sha256Hex(bytes);
  Lock lock(MutexOf(digest));
  if (const auto old = PosixFile::OpenToRead(BlobPath(digest)); old.ok()) {
    const auto got = DigestOf(*old);
    if (got.ok() && *got == digest) {
      Touch(BlobPath(digest));
      return digest;
    }
  }
  const std::string path = absl::StrCat(root_, "/tmp/", next_tmp_++);
  absl::Status written = [&]() -> absl::Status {
    const auto file = PosixFile::OpenToWrite(path);
    if (!file.ok()) return file.status();
    return file->WriteAt(0, bytes);
  }();
  if (written.ok()) written = Complete(path, digest);
  if (!written.ok()) {
    RemoveFile(path).IgnoreError();
    return written;
  }
  return digest;
}

/// Puts a damaged blob aside, unless a good one has taken its place since it was read.
absl::Status DirectoryBlobStore::Corrupt(const std::string& digest, const std::string& got) {
  Lock lock(MutexOf(digest));
  const auto file = OpenBlob(BlobPath(digest), digest);
  const auto now = file.ok() ? DigestOf(*file) : file.status();
  if (now.ok() && *now != digest) {
    const std::string aside = absl::StrCat(root_, "/corrupt/", digest);
    RenameDurably(BlobPath(digest), aside).IgnoreError();  // the error below is the one that counts
  }
  return BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
}

absl::StatusOr<std::unique_ptr<BlobReader>> DirectoryBlobStore::Open(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  auto file = OpenBlob(BlobPath(digest), digest);
  if (!file.ok()) return file.status();
  const auto got = DigestOf(*file);
  if (!got.ok()) return got.status();
  if (*got != digest) return Corrupt(digest, *got);
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
  Lock lock(MutexOf(digest));
  Touch(BlobPath(digest));
  return StatusLocked(digest);
}

absl::StatusOr<bool> DirectoryBlobStore::Delete(const std::string& digest, double idle_s) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  Lock lock(MutexOf(digest));
  bool deleted = false;
  for (const std::string& path : {BlobPath(digest), UploadPath(digest)}) {
    const auto idle = IdleSeconds(path);
    if (!idle || *idle < idle_s) continue;
    if (absl::Status removed = RemoveFile(path); !removed.ok()) return removed;
    deleted = true;
  }
  return deleted;
}

absl::Status DirectoryBlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  namespace fs = std::filesystem;
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
      visit(entry);
    }
    if (error) {
      return MakeError(absl::StatusCode::kInternal, Reason::kStoreFailed,
                       absl::StrCat("list ", root_, ": ", error.message()));
    }
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
