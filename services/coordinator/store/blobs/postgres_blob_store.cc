#include "services/coordinator/store/blobs/postgres_blob_store.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "common/base/sha256.h"
#include "services/coordinator/store/blobs/blob_errors.h"
#include "services/coordinator/store/blobs/blob_pages.h"

namespace slicefarm::coordinator {
namespace {

/// Key of a row.
struct Key {
  std::string tenant;
  std::string digest;
};

absl::StatusOr<BlobStatus> SelectStatus(SqlConnection& db, const Key& key, bool lock) {
  SqlQuery query(
      db, lock ? "SELECT size, complete FROM blobs WHERE tenant = ? AND digest = ? FOR UPDATE"
               : "SELECT size, complete FROM blobs WHERE tenant = ? AND digest = ?");
  BlobStatus status;
  if (query.Bind(key.tenant, key.digest).Next()) status = {query.Int(0), query.Int(1) != 0};
  if (!query.status().ok()) return query.status();
  return status;
}

/// Creates the blob's row if it does not exist, and locks it. So only one transaction at a time
/// writes a blob.
absl::StatusOr<BlobStatus> LockBlob(SqlConnection& db, const Key& key) {
  SqlQuery make(db,
                "INSERT INTO blobs (tenant, digest, size, complete) VALUES (?, ?, 0, 0)"
                " ON CONFLICT DO NOTHING");
  if (absl::Status done = make.Bind(key.tenant, key.digest).Run(); !done.ok()) return done;
  return SelectStatus(db, key, /*lock=*/true);
}

absl::Status AddPiece(SqlConnection& db, const Key& key, int64_t at, std::string_view bytes) {
  SqlQuery add(db, "INSERT INTO blob_pieces (tenant, digest, at, bytes) VALUES (?, ?, ?, ?)");
  return add.Bind(key.tenant, key.digest, at, Blob{bytes}).Run();
}

/// Adds a piece to the end of an upload in one statement, which is sufficient for most pieces.
/// Returns false if the upload does not end at the offset of the piece. The statement does not wait
/// for the disk: only Finish acknowledges the upload, and Finish waits for the disk.
absl::StatusOr<bool> Extend(SqlConnection& db, const Key& key, int64_t at, std::string_view bytes) {
  SqlQuery extend(
      db,
      "WITH grown AS (UPDATE blobs SET size = size + ?, touched = now() WHERE tenant = ?"
      "  AND digest = ? AND size = ? AND complete = 0 RETURNING tenant, digest)"
      " INSERT INTO blob_pieces (tenant, digest, at, bytes) SELECT tenant, digest, ?::BIGINT, "
      "?::BYTEA"
      " FROM grown, set_config('synchronous_commit', 'off', true) RETURNING at");
  extend.Bind(static_cast<int64_t>(bytes.size()), key.tenant, key.digest, at, at, Blob{bytes});
  bool extended = false;
  while (extend.Next()) extended = true;
  if (!extend.status().ok()) return extend.status();
  return extended;
}

/// Creates a complete blob of one piece in one statement, which is sufficient for most results.
/// Returns false if a row of the blob exists already.
absl::StatusOr<bool> MakeSmall(SqlConnection& db, const Key& key, std::string_view bytes) {
  SqlQuery make(db,
                "WITH made AS (INSERT INTO blobs (tenant, digest, size, complete)"
                "  VALUES (?, ?, ?, 1) ON CONFLICT DO NOTHING RETURNING tenant, digest)"
                " INSERT INTO blob_pieces (tenant, digest, at, bytes)"
                " SELECT tenant, digest, 0, ?::BYTEA FROM made RETURNING at");
  make.Bind(key.tenant, key.digest, std::ssize(bytes), Blob{bytes});
  bool made = false;
  while (make.Next()) made = true;
  if (!make.status().ok()) return make.status();
  return made;
}

absl::Status SetStatus(SqlConnection& db, const Key& key, const BlobStatus& status) {
  SqlQuery set(db,
               "UPDATE blobs SET size = ?, complete = ?, touched = now()"
               " WHERE tenant = ? AND digest = ?");
  return set.Bind(status.committed_size, status.complete, key.tenant, key.digest).Run();
}

absl::Status Remove(SqlConnection& db, const Key& key) {
  SqlQuery remove(db, "DELETE FROM blobs WHERE tenant = ? AND digest = ?");
  return remove.Bind(key.tenant, key.digest).Run();
}

/// Returns up to `limit` bytes from `offset` on.
absl::StatusOr<std::string> ReadBytes(SqlConnection& db, const Key& key, int64_t offset,
                                      int64_t limit) {
  SqlQuery query(db,
                 "SELECT at, bytes FROM blob_pieces WHERE tenant = ? AND digest = ? AND at < ?"
                 // max(at) is not used, because it would read all pieces before this one.
                 " AND at >= (SELECT at FROM blob_pieces WHERE tenant = ? AND digest = ?"
                 "  AND at <= ? ORDER BY at DESC LIMIT 1) ORDER BY at");
  query.Bind(key.tenant, key.digest, offset + limit, key.tenant, key.digest, offset);
  std::string bytes;
  while (query.Next()) {
    const std::string piece = query.Text(1);
    const auto have = static_cast<int64_t>(bytes.size());
    const int64_t skip = offset + have - query.Int(0);
    if (skip < 0 || skip > static_cast<int64_t>(piece.size())) break;  // a piece is missing
    bytes.append(piece, skip, limit - have);
  }
  if (!query.status().ok()) return query.status();
  return bytes;
}

/// Reads all bytes of a blob piece by piece and returns their digest. A mesh of 2 GB in one answer
/// would need as much memory again, and more time than the limit of a statement.
absl::StatusOr<std::string> ReadPieces(SqlConnection& db, const Key& key,
                                       const std::function<void(const std::string&)>& visit) {
  Sha256 sha;
  for (int64_t offset = 0;;) {
    const auto bytes = ReadBytes(db, key, offset, kBlobPieceBytes);
    if (!bytes.ok()) return bytes.status();
    sha.Add(*bytes);
    visit(*bytes);
    offset += std::ssize(*bytes);
    if (std::ssize(*bytes) < kBlobPieceBytes) return sha.Hex();
  }
}

absl::StatusOr<std::string> DigestOf(SqlConnection& db, const Key& key) {
  return ReadPieces(db, key, [](const std::string&) {});
}

/// Returns the size of a complete blob. Errors: BLOB_NOT_FOUND.
absl::StatusOr<int64_t> SizeOf(SqlConnection& db, const Key& key) {
  const auto status = SelectStatus(db, key, /*lock=*/false);
  if (!status.ok()) return status.status();
  if (!status->complete) return BlobNotFound(key.digest);
  return status->committed_size;
}

class PostgresReader : public BlobReader {
 public:
  PostgresReader(std::shared_ptr<SqlDatabase> database, Key key, int64_t size)
      : database_(std::move(database)), key_(std::move(key)), size_(size) {}

  int64_t size() const override { return size_; }

 private:
  absl::StatusOr<std::string> ReadWithin(int64_t offset, int64_t count) override {
    const auto session = database_->Read();
    if (!session.ok()) return session.status();
    return ReadBytes(**session, key_, offset, count);
  }

  const std::shared_ptr<SqlDatabase> database_;
  const Key key_;
  const int64_t size_;
};

}  // namespace

absl::StatusOr<BlobStatus> PostgresBlobStore::Status(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return SelectStatus(**session, {tenant_, digest}, /*lock=*/false);
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Append(const std::string& digest, int64_t offset,
                                                     std::string_view bytes) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  const Key key = {tenant_, digest};
  if (offset > 0 && !bytes.empty()) {
    const auto extended = Extend(db, key, offset, bytes);
    if (!extended.ok()) return extended.status();
    if (*extended) return BlobStatus{offset + std::ssize(bytes), /*complete=*/false};
  }
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  absl::Status done = SqlQuery(db, "SET LOCAL synchronous_commit = off").Run();
  if (!done.ok()) return done;
  auto status = LockBlob(db, key);
  if (!status.ok() || status->complete) return status;
  const int64_t committed = status->committed_size;
  if (offset < 0 || offset > committed) return UploadOffset(digest, committed, offset);
  bytes.remove_prefix(std::min<int64_t>(committed - offset, static_cast<int64_t>(bytes.size())));
  if (bytes.empty()) return status;
  if (done = AddPiece(db, key, committed, bytes); !done.ok()) return done;
  status->committed_size += static_cast<int64_t>(bytes.size());
  if (done = SetStatus(db, key, *status); !done.ok()) return done;
  if (done = transaction.Commit(); !done.ok()) return done;
  return status;
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Finish(const std::string& digest, int64_t size) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  const Key key = {tenant_, digest};
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  auto status = LockBlob(db, key);
  if (!status.ok()) return status;
  if (!status->complete) {
    if (status->committed_size < size) return UploadOffset(digest, status->committed_size, size);
    const auto got = DigestOf(db, key);
    if (!got.ok()) return got.status();
    if (*got != digest) {
      if (absl::Status done = Remove(db, key); !done.ok()) return done;
      if (absl::Status done = transaction.Commit(); !done.ok()) return done;
      return BlobMismatch(absl::StatusCode::kInvalidArgument, digest, *got);
    }
    status->complete = true;
  }
  if (absl::Status done = SetStatus(db, key, *status); !done.ok()) return done;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return status;
}

/// Reads the text twice, because its digest is the key of its pieces.
absl::StatusOr<std::string> PostgresBlobStore::PutText(const SpooledText& text) {
  const bool small = text.size() > 0 && text.size() <= kBlobPieceBytes;
  Sha256 sha;
  std::string all;  // bytes of a small text
  const auto add = [&](std::string_view bytes) {
    sha.Add(bytes);
    if (small) all += bytes;
    return absl::OkStatus();
  };
  if (absl::Status read = text.ForEachBlock(add); !read.ok()) return read;
  const std::string digest = sha.Hex();
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  const Key key = {tenant_, digest};
  if (small) {
    const auto made = MakeSmall(db, key, all);
    if (!made.ok()) return made.status();
    if (*made) return digest;
  }
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  const auto old = LockBlob(db, key);
  if (!old.ok()) return old.status();
  const auto got = old->complete ? DigestOf(db, key) : std::string();
  if (!got.ok()) return got.status();
  if (*got != digest) {  // the blob is missing, incomplete or damaged
    SqlQuery clear(db, "DELETE FROM blob_pieces WHERE tenant = ? AND digest = ?");
    if (absl::Status done = clear.Bind(tenant_, digest).Run(); !done.ok()) return done;
    int64_t at = 0;
    const absl::Status added = text.ForEachBlock([&](std::string_view bytes) {
      return AddPiece(db, key, std::exchange(at, at + std::ssize(bytes)), bytes);
    });
    if (!added.ok()) return added;
  }
  absl::Status done = SetStatus(db, key, {text.size(), true});
  if (!done.ok()) return done;
  if (done = transaction.Commit(); !done.ok()) return done;
  return digest;
}

/// Puts a damaged blob aside, unless it was replaced by a good one after it was read.
absl::Status PostgresBlobStore::Corrupt(const std::string& digest, const std::string& got) {
  const absl::Status damaged = BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
  const auto session = database_->Write();
  if (!session.ok()) return damaged;
  SqlConnection& db = **session;
  const Key key = {tenant_, digest};
  SqlTransaction transaction(db);
  if (!transaction.status().ok() || !SelectStatus(db, key, /*lock=*/true).ok()) return damaged;
  if (const auto now = DigestOf(db, key); !now.ok() || *now == digest) return damaged;
  const Key aside = {tenant_, "corrupt/" + digest};
  SqlQuery move(db,
                "UPDATE blobs SET digest = ?, complete = 0, touched = now()"
                " WHERE tenant = ? AND digest = ?");
  if (Remove(db, aside).ok() && move.Bind(aside.digest, tenant_, digest).Run().ok()) {
    transaction.Commit().IgnoreError();  // the caller needs the error of the damage
  }
  return damaged;
}

/// Reads a blob and checks it against its name. If `bytes` is not null, the blob's bytes are stored
/// there. Returns the size of the blob.
absl::StatusOr<int64_t> PostgresBlobStore::Check(const std::string& digest, std::string* bytes) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const Key key = {tenant_, digest};
  auto session = database_->Read();
  if (!session.ok()) return session.status();
  const auto size = SizeOf(**session, key);
  if (!size.ok()) return size;
  if (bytes != nullptr) bytes->reserve(*size);
  const auto got = ReadPieces(**session, key, [&](const std::string& piece) {
    if (bytes != nullptr) *bytes += piece;
  });
  session->reset();
  if (!got.ok()) return got.status();
  if (*got != digest) {
    checked_.Forget(digest);
    return Corrupt(digest, *got);
  }
  return size;
}

absl::StatusOr<std::unique_ptr<BlobReader>> PostgresBlobStore::Open(const std::string& digest) {
  auto reader = OpenUnchecked(digest);
  if (!reader.ok() || checked_.Holds(digest, {(*reader)->size()})) return reader;
  const auto size = Check(digest, /*bytes=*/nullptr);
  if (!size.ok()) return size.status();
  checked_.Add(digest, {*size});
  return reader;
}

absl::StatusOr<std::unique_ptr<BlobReader>> PostgresBlobStore::OpenUnchecked(
    const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  const auto size = SizeOf(**session, {tenant_, digest});
  if (!size.ok()) return size.status();
  return std::make_unique<PostgresReader>(database_, Key{tenant_, digest}, *size);
}

absl::StatusOr<std::string> PostgresBlobStore::Get(const std::string& digest) {
  std::string bytes;
  if (const auto size = Check(digest, &bytes); !size.ok()) return size.status();
  return bytes;
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Keep(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery touch(**session,
                 "UPDATE blobs SET touched = now()"
                 " WHERE tenant = ? AND digest = ? AND complete = 1 RETURNING size");
  touch.Bind(tenant_, digest);
  std::optional<BlobStatus> kept;
  while (touch.Next()) kept = {touch.Int(0), /*complete=*/true};
  if (!touch.status().ok()) return touch.status();
  if (kept) return *kept;
  return SelectStatus(**session, {tenant_, digest}, /*lock=*/false);
}

absl::StatusOr<bool> PostgresBlobStore::Delete(const std::string& digest, double idle_s) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery remove(**session,
                  "DELETE FROM blobs WHERE tenant = ? AND digest = ?"
                  " AND touched <= now() - ? * interval '1 microsecond' RETURNING digest");
  remove.Bind(tenant_, digest, static_cast<int64_t>(idle_s * 1e6));
  bool deleted = false;
  while (remove.Next()) deleted = true;
  if (!remove.status().ok()) return remove.status();
  if (deleted) checked_.Forget(digest);
  return deleted;
}

absl::StatusOr<int64_t> PostgresBlobStore::KeptBytes() {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT coalesce(sum(size), 0)::BIGINT FROM blobs"
                 " WHERE tenant = ? AND digest NOT LIKE 'corrupt/%'");
  if (!query.Bind(tenant_).Next()) return query.status();
  return query.Int(0);
}

absl::StatusOr<int64_t> PostgresBlobStore::DropDamaged(double aside_s) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  // No digest is between these bounds, in any text order of a database.
  SqlQuery remove(**session,
                  "DELETE FROM blobs WHERE tenant = ? AND digest > 'cn' AND digest < 'd'"
                  " AND touched <= now() - ? * interval '1 microsecond' RETURNING size");
  remove.Bind(tenant_, static_cast<int64_t>(aside_s * 1e6));
  int64_t bytes = 0;
  while (remove.Next()) bytes += remove.Int(0);
  if (!remove.status().ok()) return remove.status();
  return bytes;
}

absl::Status PostgresBlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  return ForEachBlobOf(
      *database_,
      "SELECT digest, size, complete, (extract(epoch FROM now() - touched) * 1000000)::BIGINT"
      " FROM blobs WHERE digest NOT LIKE 'corrupt/%' AND",
      tenant_,
      [](const SqlQuery& row) {
        return BlobEntry{row.Text(0), row.Int(1), row.Int(2) != 0,
                         static_cast<double>(row.Int(3)) * 1e-6};
      },
      visit);
}

}  // namespace slicefarm::coordinator
