#include "services/coordinator/store/s3/s3_blob_store.h"

#include <openssl/rand.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <utility>
#include <vector>

#include "absl/strings/escaping.h"
#include "absl/strings/str_cat.h"
#include "common/base/error.h"
#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/blob_errors.h"
#include "services/coordinator/store/s3/s3_reader.h"

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kLooseAtOnce = 1'000;

int64_t NowUs() {
  return std::chrono::duration_cast<std::chrono::microseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::string Random() {
  std::array<unsigned char, 12> bytes = {};
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) std::abort();
  return absl::BytesToHexString({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string DigestOf(const SpooledText& text, absl::Status& status) {
  Sha256 sha;
  status = text.ForEachBlock([&](std::string_view bytes) {
    sha.Add(bytes);
    return absl::OkStatus();
  });
  return sha.Hex();
}

bool IsOffset(const absl::Status& status) {
  return DetailOf(status).reason == Reason::kUploadOffset;
}

}  // namespace

S3BlobStore::S3BlobStore(std::shared_ptr<S3Client> bucket, std::shared_ptr<SqlDatabase> database,
                         std::shared_ptr<BlobStore> staged, std::string tenant)
    : bucket_(std::move(bucket)),
      staged_(std::move(staged)),
      folder_(tenant.empty() ? "blobs" : absl::StrCat("tenants/", tenant, "/blobs")),
      index_(std::make_shared<S3Index>(std::move(database), std::move(tenant))) {}

absl::StatusOr<BlobStatus> S3BlobStore::Status(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  // The blob is checked again at the end, because an upload may become a blob between the two
  // checks.
  for (const bool again : {false, true}) {
    const auto found = index_->Find(digest);
    if (!found.ok()) return found.status();
    if (*found) return BlobStatus{(*found)->size, /*complete=*/true};
    const auto status = staged_->Status(digest);
    if (!status.ok() || status->committed_size > 0 || again) return status;
  }
  return BlobStatus{};
}

absl::StatusOr<BlobStatus> S3BlobStore::Keep(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  for (const bool again : {false, true}) {
    const auto found = index_->Touch(digest, NowUs());
    if (!found.ok()) return found.status();
    if (*found) return BlobStatus{(*found)->size, /*complete=*/true};
    const auto status = staged_->Keep(digest);
    if (!status.ok() || status->committed_size > 0 || again) return status;
  }
  return BlobStatus{};
}

absl::StatusOr<BlobStatus> S3BlobStore::Append(const std::string& digest, int64_t offset,
                                               std::string_view bytes) {
  const auto known = Status(digest);
  if (!known.ok() || known->complete) return known;
  auto status = staged_->Append(digest, offset, bytes);
  if (!IsOffset(status.status())) return status;
  const auto now = Status(digest);  // the upload may have become a blob
  return now.ok() && now->complete ? now : status;
}

absl::StatusOr<BlobStatus> S3BlobStore::Finish(const std::string& digest, int64_t size) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto moving = movers_.Take(digest);
  const auto found = index_->Touch(digest, NowUs());
  if (!found.ok()) return found.status();
  if (*found) return BlobStatus{(*found)->size, /*complete=*/true};
  auto status = staged_->Finish(digest, size);
  if (!status.ok()) {
    const auto now = Status(digest);  // another process may have finished the upload
    return IsOffset(status.status()) && now.ok() && now->complete ? now : status;
  }
  return Move(digest);
}

/// Moves a complete blob of the staging store into the bucket, unless the bucket has it already.
absl::StatusOr<BlobStatus> S3BlobStore::Move(const std::string& digest) {
  const auto found = index_->Touch(digest, NowUs());
  if (!found.ok()) return found.status();
  const auto reader = staged_->OpenUnchecked(digest);
  // Another process has moved the blob.
  if (absl::IsNotFound(reader.status())) return Status(digest);
  if (!reader.ok()) return reader.status();
  const BodySource body{(*reader)->size(), [&](int64_t offset, int64_t limit) {
                          return (*reader)->Read(offset, limit);
                        }};
  if (!*found) {
    if (absl::Status put = PutObject(digest, body); !put.ok()) return put;
  }
  if (const auto deleted = staged_->Delete(digest, 0); !deleted.ok()) return deleted.status();
  return BlobStatus{body.size, /*complete=*/true};
}

/// Puts an object and makes it the blob. After a failure in between, the sweep deletes the object.
absl::Status S3BlobStore::PutObject(const std::string& digest, const BodySource& body) {
  const S3Index::Found object = {
      absl::StrCat(folder_, "/", digest.substr(0, 2), "/", digest, ".", Random()), body.size};
  if (absl::Status begun = index_->Begin(object.object, NowUs()); !begun.ok()) return begun;
  if (absl::Status put = bucket_->Put(object.object, digest, body); !put.ok())
    return BucketAway(put);
  const auto made = index_->Complete(digest, object, NowUs());
  if (!made.ok()) return BucketAway(made.status());
  if (*made) return absl::OkStatus();
  if (absl::Status deleted = bucket_->Delete(object.object); !deleted.ok())
    return absl::OkStatus();  // the sweep will delete the object
  return index_->Forget(object.object);
}

/// Returns true if the object of the blob exists, and marks the blob as used. If the object is
/// missing, its row is removed and the blob must be put again.
absl::StatusOr<bool> S3BlobStore::HasGood(const std::string& digest) {
  const auto found = index_->Touch(digest, NowUs());
  if (!found.ok()) return found.status();
  if (!*found) return false;
  const auto size = bucket_->Size((*found)->object);
  if (size.ok() && *size == (*found)->size) return true;
  if (!size.ok() && !absl::IsNotFound(size.status())) return BucketAway(size.status());
  checked_.Forget(digest);
  if (absl::Status done = index_->PutAside(digest, (*found)->object, NowUs()); !done.ok())
    return done;
  return false;
}

absl::StatusOr<std::string> S3BlobStore::PutText(const SpooledText& text) {
  absl::Status read;
  const std::string digest = DigestOf(text, read);
  if (!read.ok()) return read;
  const auto moving = movers_.Take(digest);
  const auto here = HasGood(digest);
  if (!here.ok()) return here.status();
  if (*here) return digest;
  const BodySource body{text.size(),
                        [&](int64_t offset, int64_t limit) { return text.Read(offset, limit); }};
  if (absl::Status put = PutObject(digest, body); !put.ok()) return put;
  if (const auto deleted = staged_->Delete(digest, 0); !deleted.ok()) return deleted.status();
  return digest;
}

/// Returns the digest of an object. If `bytes` is not null, the object's bytes are appended to it.
/// Errors: DataLoss if the object is missing.
absl::StatusOr<std::string> S3BlobStore::Digest(const S3Index::Found& found, std::string* bytes) {
  S3Reader reader(bucket_, found);
  Sha256 sha;
  for (int64_t offset = 0; offset < found.size;) {
    const auto piece = reader.Read(offset, kBlobPieceBytes);
    if (!piece.ok()) return piece.status();
    sha.Add(*piece);
    if (bytes != nullptr) *bytes += *piece;
    offset += std::ssize(*piece);
  }
  return sha.Hex();
}

/// Checks an object against the blob's name. Reads it twice before it counts as damaged, because
/// bytes may change in transfer. Puts a damaged object aside, unless another object has become the
/// blob.
absl::Status S3BlobStore::Check(const std::string& digest, const S3Index::Found& found,
                                std::string* bytes) {
  std::string got;
  for (int tries = 0; tries < 2; ++tries) {
    if (bytes != nullptr) bytes->clear();
    auto read = Digest(found, bytes);
    if (!read.ok() && !absl::IsDataLoss(read.status())) return read.status();
    got = read.ok() ? *std::move(read) : "of an object that is gone";
    if (got == digest) return absl::OkStatus();
  }
  checked_.Forget(digest);
  if (absl::Status done = index_->PutAside(digest, found.object, NowUs()); !done.ok()) return done;
  return BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
}

absl::StatusOr<std::unique_ptr<BlobReader>> S3BlobStore::Open(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  for (const bool again : {false, true}) {
    const auto found = index_->Find(digest);
    if (!found.ok()) return found.status();
    if (*found) {
      if (!checked_.Holds(digest, {(*found)->size})) {
        absl::Status checked = Check(digest, **found, /*bytes=*/nullptr);
        if (!checked.ok()) return checked;
        checked_.Add(digest, {(*found)->size});
      }
      return std::make_unique<S3Reader>(bucket_, **found);
    }
    auto reader = staged_->Open(digest);
    if (reader.ok())
      return std::make_unique<MovingReader>(*std::move(reader), digest, bucket_, index_);
    if (!absl::IsNotFound(reader.status()) || again) return reader;
  }
  return BlobNotFound(digest);
}

absl::StatusOr<std::unique_ptr<BlobReader>> S3BlobStore::OpenUnchecked(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  for (const bool again : {false, true}) {
    const auto found = index_->Find(digest);
    if (!found.ok()) return found.status();
    if (*found) return std::make_unique<S3Reader>(bucket_, **found);
    auto reader = staged_->OpenUnchecked(digest);
    if (reader.ok())
      return std::make_unique<MovingReader>(*std::move(reader), digest, bucket_, index_);
    if (!absl::IsNotFound(reader.status()) || again) return reader;
  }
  return BlobNotFound(digest);
}

absl::StatusOr<std::string> S3BlobStore::Get(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  for (const bool again : {false, true}) {
    const auto found = index_->Find(digest);
    if (!found.ok()) return found.status();
    if (*found) {
      std::string bytes;
      bytes.reserve(static_cast<size_t>((*found)->size));
      if (absl::Status checked = Check(digest, **found, &bytes); !checked.ok()) return checked;
      return bytes;
    }
    auto bytes = staged_->Get(digest);
    if (!absl::IsNotFound(bytes.status()) || again) return bytes;
  }
  return BlobNotFound(digest);
}

/// Removes the row of the blob, and then its object. If the object cannot be deleted now, the sweep
/// deletes it later.
absl::StatusOr<bool> S3BlobStore::Delete(const std::string& digest, double idle_s) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto loosened = index_->Loosen(digest, idle_s, NowUs());
  if (!loosened.ok()) return loosened.status();
  if (*loosened) {
    checked_.Forget(digest);
    const std::string& object = (*loosened)->object;
    if (bucket_->Delete(object).ok()) {
      if (absl::Status done = index_->Forget(object); !done.ok()) return done;
    }
  }
  const auto staged = staged_->Delete(digest, idle_s);
  if (!staged.ok()) return staged;
  return loosened->has_value() || *staged;
}

absl::StatusOr<int64_t> S3BlobStore::KeptBytes() {
  const auto here = index_->Bytes();
  if (!here.ok()) return here;
  const auto staged = staged_->KeptBytes();
  if (!staged.ok()) return staged;
  return *here + *staged;
}

absl::StatusOr<int64_t> S3BlobStore::DropDamaged(double aside_s) {
  for (bool more = true; more;) {
    const auto loose = index_->Loose(aside_s, NowUs(), kLooseAtOnce);
    if (!loose.ok()) return loose.status();
    more = static_cast<int32_t>(loose->size()) == kLooseAtOnce;
    for (const std::string& object : *loose) {
      if (absl::Status deleted = bucket_->Delete(object); !deleted.ok()) return BucketAway(deleted);
      if (absl::Status done = index_->Forget(object); !done.ok()) return done;
    }
  }
  return staged_->DropDamaged(aside_s);
}

absl::Status S3BlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  if (absl::Status done = index_->ForEach(visit, NowUs()); !done.ok()) return done;
  return staged_->ForEach(visit);
}

absl::Status S3BlobStore::MoveStaged(const std::function<void(const BlobEntry&)>& moved) {
  std::vector<BlobEntry> complete;
  absl::Status listed = staged_->ForEach([&](const BlobEntry& blob) {
    if (blob.complete) complete.push_back(blob);
  });
  if (!listed.ok()) return listed;
  for (const BlobEntry& blob : complete) {
    const auto moving = movers_.Take(blob.digest);
    const auto opened = staged_->Open(blob.digest);  // Open puts a damaged blob aside
    if (!opened.ok() && (absl::IsNotFound(opened.status()) || absl::IsDataLoss(opened.status())))
      continue;
    if (!opened.ok()) return opened.status();
    if (const auto status = Move(blob.digest); !status.ok()) return status.status();
    moved(blob);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
