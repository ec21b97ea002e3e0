#include "services/coordinator/store/s3/s3_index.h"

#include <utility>

#include "services/coordinator/store/blobs/blob_pages.h"

namespace slicefarm::coordinator {
namespace {

/// Longest time that the PUT of an object can take. A stalled PUT is aborted within a minute.
constexpr int64_t kPutWithinUs = int64_t{24} * 3600 * 1'000'000;

// States of loose objects.
constexpr const char* kPutting = "PUTTING";
constexpr const char* kGone = "GONE";
constexpr const char* kDamaged = "DAMAGED";

int64_t MicrosOf(double seconds) { return static_cast<int64_t>(seconds * 1e6); }

absl::Status AddLoose(SqlConnection& db, const std::string& object, const std::string& tenant,
                      const char* state, int64_t now_us) {
  SqlQuery add(db, "INSERT INTO s3_loose (object, tenant, state, since_us) VALUES (?, ?, ?, ?)");
  return add.Bind(object, tenant, state, now_us).Run();
}

/// Returns the only row of a statement. Reads the statement to its end.
absl::StatusOr<std::optional<S3Index::Found>> OneOf(SqlQuery& query) {
  std::optional<S3Index::Found> found;
  while (query.Next()) found = {query.Text(0), query.Int(1)};
  if (!query.status().ok()) return query.status();
  return found;
}

}  // namespace

absl::StatusOr<std::optional<S3Index::Found>> S3Index::Find(const std::string& digest) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT object, size FROM s3_blobs WHERE tenant = ? AND digest = ?");
  query.Bind(tenant_, digest);
  return OneOf(query);
}

absl::StatusOr<std::optional<S3Index::Found>> S3Index::Touch(const std::string& digest,
                                                             int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery touch(**session,
                 "UPDATE s3_blobs SET touched_us = ? WHERE tenant = ? AND digest = ?"
                 " RETURNING object, size");
  touch.Bind(now_us, tenant_, digest);
  return OneOf(touch);
}

absl::Status S3Index::Begin(const std::string& object, int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  return AddLoose(**session, object, tenant_, kPutting, now_us);
}

absl::StatusOr<bool> S3Index::Complete(const std::string& digest, const Found& object,
                                       int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  bool made = false;
  {
    SqlQuery make(db,
                  "INSERT INTO s3_blobs (tenant, digest, object, size, touched_us)"
                  " VALUES (?, ?, ?, ?, ?) ON CONFLICT DO NOTHING RETURNING size");
    make.Bind(tenant_, digest, object.object, object.size, now_us);
    while (make.Next()) made = true;
    if (!make.status().ok()) return make.status();
  }
  if (!made) return false;
  bool known = false;
  SqlQuery take(db, "DELETE FROM s3_loose WHERE object = ? RETURNING object");
  take.Bind(object.object);
  while (take.Next()) known = true;
  if (!take.status().ok()) return take.status();
  if (!known) return absl::AbortedError("the object was given up before it was put");
  if (absl::Status done = transaction.Commit(); !done.ok()) return done;
  return true;
}

/// Removes the row of a blob and makes its object loose. `object`: only if this is the blob's
/// object; empty: for any object.
absl::StatusOr<std::optional<S3Index::Found>> S3Index::Remove(const std::string& digest,
                                                              const std::string& object,
                                                              int64_t touched_before_us,
                                                              const char* state, int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlConnection& db = **session;
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  SqlQuery remove(db,
                  "DELETE FROM s3_blobs WHERE tenant = ? AND digest = ? AND touched_us <= ?"
                  " AND (object = ? OR ? = '') RETURNING object, size");
  remove.Bind(tenant_, digest, touched_before_us, object, object);
  auto removed = OneOf(remove);
  if (!removed.ok() || !*removed) return removed;
  absl::Status done = AddLoose(db, (*removed)->object, tenant_, state, now_us);
  if (done.ok()) done = transaction.Commit();
  if (!done.ok()) return done;
  return removed;
}

absl::StatusOr<std::optional<S3Index::Found>> S3Index::Loosen(const std::string& digest,
                                                              double idle_s, int64_t now_us) {
  return Remove(digest, "", now_us - MicrosOf(idle_s), kGone, now_us);
}

absl::Status S3Index::PutAside(const std::string& digest, const std::string& object,
                               int64_t now_us) {
  return Remove(digest, object, INT64_MAX, kDamaged, now_us).status();
}

absl::StatusOr<std::vector<std::string>> S3Index::Loose(double aside_s, int64_t now_us,
                                                        int32_t limit) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT object FROM s3_loose WHERE tenant = ? AND ((state = 'GONE')"
                 " OR (state = 'DAMAGED' AND since_us <= ?)"
                 " OR (state = 'PUTTING' AND since_us <= ?)) ORDER BY object LIMIT ?");
  query.Bind(tenant_, now_us - MicrosOf(aside_s), now_us - kPutWithinUs, limit);
  std::vector<std::string> objects;
  while (query.Next()) objects.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  return objects;
}

absl::Status S3Index::Forget(const std::string& object) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  return SqlQuery(**session, "DELETE FROM s3_loose WHERE object = ?").Bind(object).Run();
}

absl::StatusOr<int64_t> S3Index::Bytes() {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT CAST(coalesce(sum(size), 0) AS BIGINT) FROM s3_blobs WHERE tenant = ?");
  if (!query.Bind(tenant_).Next()) return query.status();
  return query.Int(0);
}

absl::Status S3Index::ForEach(const std::function<void(const BlobEntry&)>& visit, int64_t now_us) {
  return ForEachBlobOf(
      *database_, "SELECT digest, size, touched_us FROM s3_blobs WHERE", tenant_,
      [now_us](const SqlQuery& row) {
        return BlobEntry{row.Text(0), row.Int(1), /*complete=*/true,
                         static_cast<double>(now_us - row.Int(2)) * 1e-6};
      },
      visit);
}

absl::StatusOr<std::vector<std::string>> S3Index::Tenants(SqlDatabase& database) {
  const auto session = database.Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT tenant FROM s3_blobs UNION SELECT tenant FROM s3_loose");
  std::vector<std::string> tenants;
  while (query.Next()) tenants.push_back(query.Text(0));
  if (!query.status().ok()) return query.status();
  return tenants;
}

}  // namespace slicefarm::coordinator
