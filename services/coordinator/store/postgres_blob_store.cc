#include "services/coordinator/store/postgres_blob_store.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "common/model/sha256.h"
#include "services/coordinator/store/blob_errors.h"

namespace slicefarm::coordinator {
namespace {

constexpr int64_t kPieceBytes = 1 << 20;
constexpr int32_t kListed = 1000;  ///< blobs a query

absl::StatusOr<BlobStatus> SelectStatus(SqlConnection& db, const std::string& digest, bool lock) {
  SqlQuery query(db, lock ? "SELECT size, complete FROM blobs WHERE digest = ? FOR UPDATE"
                          : "SELECT size, complete FROM blobs WHERE digest = ?");
  BlobStatus status;
  if (query.Bind(digest).Next()) status = {query.Int(0), query.Int(1) != 0};
  if (!query.status().ok()) return query.status();
  return status;
}

/// Makes the blob's row if there is none, and holds it: one write to a blob at a time.
absl::StatusOr<BlobStatus> LockBlob(SqlConnection& db, const std::string& digest) {
  SqlQuery make(db,
                "INSERT INTO blobs (digest, size, complete) VALUES (?, 0, 0)"
                " ON CONFLICT DO NOTHING");
  if (absl::Status done = make.Bind(digest).Run(); !done.ok()) return done;
  return SelectStatus(db, digest, /*lock=*/true);
}

absl::Status AddPiece(SqlConnection& db, const std::string& digest, int64_t at,
                      std::string_view bytes) {
  SqlQuery add(db, "INSERT INTO blob_pieces (digest, at, bytes) VALUES (?, ?, ?)");
  return add.Bind(digest, at, Blob{bytes}).Run();
}

absl::Status SetStatus(SqlConnection& db, const std::string& digest, const BlobStatus& status) {
  SqlQuery set(db, "UPDATE blobs SET size = ?, complete = ?, touched = now() WHERE digest = ?");
  return set.Bind(status.committed_size, status.complete, digest).Run();
}

absl::Status Remove(SqlConnection& db, const std::string& digest) {
  return SqlQuery(db, "DELETE FROM blobs WHERE digest = ?").Bind(digest).Run();
}

/// Up to `limit` bytes from `offset` on.
absl::StatusOr<std::string> ReadBytes(SqlConnection& db, const std::string& digest, int64_t offset,
                                      int64_t limit) {
  SqlQuery query(db,
                 "SELECT at, bytes FROM blob_pieces WHERE digest = ? AND at < ? AND at >="
                 " (SELECT max(at) FROM blob_pieces WHERE digest = ? AND at <= ?) ORDER BY at");
  query.Bind(digest, offset + limit, digest, offset);
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

absl::StatusOr<std::string> DigestOf(SqlConnection& db, const std::string& digest) {
  Sha256 sha;
  for (int64_t offset = 0;;) {
    const auto bytes = ReadBytes(db, digest, offset, kPieceBytes);
    if (!bytes.ok()) return bytes.status();
    if (bytes->empty()) return sha.Hex();
    sha.Add(*bytes);
    offset += static_cast<int64_t>(bytes->size());
  }
}

class PostgresReader : public BlobReader {
 public:
  PostgresReader(std::shared_ptr<SqlDatabase> database, std::string digest, int64_t size)
      : database_(std::move(database)), digest_(std::move(digest)), size_(size) {}

  int64_t size() const override { return size_; }
  absl::StatusOr<std::string> Read(int64_t offset, int64_t limit) override {
    const auto session = database_->Read();
    if (!session.ok()) return session.status();
    return ReadBytes(**session, digest_, offset, std::clamp<int64_t>(size_ - offset, 0, limit));
  }

 private:
  const std::shared_ptr<SqlDatabase> database_;
  const std::string digest_;
  const int64_t size_;
};

}  // namespace

absl::StatusOr<BlobStatus> PostgresBlobStore::Status(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  return SelectStatus(**session, digest, /*lock=*/false);
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Append(const std::string& digest, int64_t offset,
                                                     std::string_view bytes) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  // An upload is acknowledged by Finish, which waits for the disk; a chunk need not.
  absl::Status done = SqlQuery(db, "SET LOCAL synchronous_commit = off").Run();
  if (!done.ok()) return done;
  auto status = LockBlob(db, digest);
  if (!status.ok() || status->complete) return status;
  const int64_t committed = status->committed_size;
  if (offset < 0 || offset > committed) return UploadOffset(digest, committed, offset);
  bytes.remove_prefix(std::min<int64_t>(committed - offset, static_cast<int64_t>(bytes.size())));
  if (bytes.empty()) return status;
  if (done = AddPiece(db, digest, committed, bytes); !done.ok()) return done;
  status->committed_size += static_cast<int64_t>(bytes.size());
  if (done = SetStatus(db, digest, *status); !done.ok()) return done;
  if (done = transaction.Commit(); !done.ok()) return done;
  return status;
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Finish(const std::string& digest, int64_t size) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  auto status = LockBlob(db, digest);
  if (!status.ok()) return status;
  if (!status->complete) {
    if (status->committed_size < size) return UploadOffset(digest, status->committed_size, size);
    const auto got = DigestOf(db, digest);
    if (!got.ok()) return got.status();
    if (*got != digest) {
      if (absl::Status done = Remove(db, digest); !done.ok()) return done;
      if (absl::Status done = transaction.Commit(); !done.ok()) return done;
      return BlobMismatch(absl::StatusCode::kInvalidArgument, digest, *got);
    }
    status->complete = true;
  }
  if (absl::Status done = SetStatus(db, digest, *status); !done.ok()) return done;
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return status;
}

absl::StatusOr<std::string> PostgresBlobStore::Put(std::string_view bytes) {
  const std::string digest = Sha256Hex(bytes);
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  const auto old = LockBlob(db, digest);
  if (!old.ok()) return old.status();
  const auto got = old->complete ? DigestOf(db, digest) : std::string();
  if (!got.ok()) return got.status();
  if (*got != digest) {  // nothing, a part of it, or a damaged one
    SqlQuery clear(db, "DELETE FROM blob_pieces WHERE digest = ?");
    if (absl::Status done = clear.Bind(digest).Run(); !done.ok()) return done;
    for (size_t at = 0; at < bytes.size(); at += kPieceBytes) {
      absl::Status done =
          AddPiece(db, digest, static_cast<int64_t>(at), bytes.substr(at, kPieceBytes));
      if (!done.ok()) return done;
    }
  }
  absl::Status done = SetStatus(db, digest, {static_cast<int64_t>(bytes.size()), true});
  if (!done.ok()) return done;
  if (done = transaction.Commit(); !done.ok()) return done;
  return digest;
}

/// Puts a damaged blob aside, unless a good one has taken its place since it was read.
absl::Status PostgresBlobStore::Corrupt(const std::string& digest, const std::string& got) {
  const absl::Status damaged = BlobMismatch(absl::StatusCode::kDataLoss, digest, got);
  const auto session = database_->Write();
  if (!session.ok()) return damaged;
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok() || !SelectStatus(db, digest, /*lock=*/true).ok()) return damaged;
  if (const auto now = DigestOf(db, digest); !now.ok() || *now == digest) return damaged;
  const std::string aside = "corrupt/" + digest;
  SqlQuery move(db, "UPDATE blobs SET digest = ?, complete = 0 WHERE digest = ?");
  if (Remove(db, aside).ok() && move.Bind(aside, digest).Run().ok()) {
    transaction.Commit().IgnoreError();  // the damage is what counts
  }
  return damaged;
}

absl::StatusOr<std::unique_ptr<BlobReader>> PostgresBlobStore::Open(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  absl::StatusOr<std::string> got;
  int64_t size = 0;
  {
    const auto session = database_->Read();
    if (!session.ok()) return session.status();
    const auto status = SelectStatus(**session, digest, /*lock=*/false);
    if (!status.ok()) return status.status();
    if (!status->complete) return BlobNotFound(digest);
    size = status->committed_size;
    got = DigestOf(**session, digest);
  }
  if (!got.ok()) return got.status();
  if (*got != digest) return Corrupt(digest, *got);
  return std::make_unique<PostgresReader>(database_, digest, size);
}

absl::StatusOr<std::string> PostgresBlobStore::Get(const std::string& digest) {
  const auto reader = Open(digest);
  if (!reader.ok()) return reader.status();
  return (*reader)->Read(0, (*reader)->size());
}

absl::StatusOr<BlobStatus> PostgresBlobStore::Keep(const std::string& digest) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery touch(**session, "UPDATE blobs SET touched = now() WHERE digest = ? AND complete = 1");
  if (absl::Status done = touch.Bind(digest).Run(); !done.ok()) return done;
  return SelectStatus(**session, digest, /*lock=*/false);
}

absl::StatusOr<bool> PostgresBlobStore::Delete(const std::string& digest, double idle_s) {
  if (absl::Status named = CheckBlobName(digest); !named.ok()) return named;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery remove(**session,
                  "DELETE FROM blobs WHERE digest = ?"
                  " AND touched <= now() - ? * interval '1 microsecond' RETURNING digest");
  remove.Bind(digest, static_cast<int64_t>(idle_s * 1e6));
  bool deleted = false;
  while (remove.Next()) deleted = true;
  if (!remove.status().ok()) return remove.status();
  return deleted;
}

absl::Status PostgresBlobStore::ForEach(const std::function<void(const BlobEntry&)>& visit) {
  std::string after;
  for (bool more = true; more;) {
    std::vector<BlobEntry> page;
    {
      const auto session = database_->Read();
      if (!session.ok()) return session.status();
      SqlQuery query(**session,
                     "SELECT digest, size, complete,"
                     " (extract(epoch FROM now() - touched) * 1000000)::BIGINT FROM blobs"
                     " WHERE digest > ? AND digest NOT LIKE 'corrupt/%' ORDER BY digest LIMIT ?");
      query.Bind(after, kListed);
      while (query.Next()) {
        page.push_back({query.Text(0), query.Int(1), query.Int(2) != 0,
                        static_cast<double>(query.Int(3)) * 1e-6});
      }
      if (!query.status().ok()) return query.status();
    }
    for (const BlobEntry& entry : page) visit(entry);
    more = static_cast<int32_t>(page.size()) == kListed;
    if (more) after = page.back().digest;
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
