#include "services/coordinator/store/jobs/sql_profile_store.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

/// Locks the revisions of a tenant until the transaction ends. Without the lock, a revision could
/// be added to a profile that another coordinator deletes at the same time.
absl::Status LockTenant(SqlConnection& db, const std::string& tenant) {
  const std::string_view lock = db.dialect().lock_tenant;
  if (lock.empty()) return absl::OkStatus();
  return SqlQuery(db, lock).Bind(tenant).Run();
}

}  // namespace

/// Returns the statement for the store's table, which is called `revisions` in `text`.
std::string SqlProfileStore::Sql(std::string_view text) const {
  constexpr std::string_view kTable = "revisions";
  std::string sql;
  for (size_t at = 0; at < text.size();) {
    const size_t found = std::min(text.find(kTable, at), text.size());
    sql += text.substr(at, found - at);
    if (found < text.size()) sql += table_.name;
    at = found + kTable.size();
  }
  return sql;
}

absl::Status SqlProfileStore::NotFound(const std::string& name, int64_t revision) const {
  const std::string wanted = revision == 0 ? name : fmt::format("{}@{}", name, revision);
  return MakeError(absl::StatusCode::kNotFound, Reason::kProfileNotFound,
                   fmt::format("there is no {} {}", table_.what, wanted), {{"profile", wanted}});
}

absl::Status SqlProfileStore::NotNewest(const NewProfile& profile, int64_t newest) const {
  return MakeError(
      absl::StatusCode::kAborted, Reason::kProfileNotFound,
      fmt::format("revision {} is not the newest one of the {} {}, {} is: read it and try again",
                  *profile.base, table_.what, profile.name, newest),
      {{"profile", profile.name}, {"revision", std::to_string(newest)}});
}

/// Returns a revision; nullopt if it does not exist. `revision` 0: the newest.
absl::StatusOr<std::optional<ProfileRecord>> SqlProfileStore::Find(SqlConnection& db,
                                                                   const std::string& tenant,
                                                                   const std::string& name,
                                                                   int64_t revision) const {
  SqlQuery query(db, Sql("SELECT revision, settings, settings_digest, create_us FROM revisions"
                         " WHERE tenant = ? AND name = ? AND (revision = ? OR ? = 0)"
                         " AND settings_digest <> '' ORDER BY revision DESC LIMIT 1"));
  if (!query.Bind(tenant, name, revision, revision).Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  return ProfileRecord{name, query.Int(0), query.Text(1), query.Text(2), query.Int(3)};
}

/// Returns the number of the last revision, including deleted ones; 0 if there is none.
absl::StatusOr<int64_t> SqlProfileStore::LastRevision(SqlConnection& db, const std::string& tenant,
                                                      const std::string& name) const {
  SqlQuery query(db, Sql("SELECT max(revision) FROM revisions WHERE tenant = ? AND name = ?"));
  const int64_t last = query.Bind(tenant, name).Next() ? query.Int(0) : 0;
  if (!query.status().ok()) return query.status();
  return last;
}

/// Checks the limits of stored revisions. There are limits because revisions are stored for long.
absl::Status SqlProfileStore::CheckSpace(SqlConnection& db, const NewProfile& profile) const {
  SqlQuery query(db, Sql(table_.max_bytes > 0 ? "SELECT count(*), coalesce(sum(length(settings)), "
                                                "0) FROM revisions WHERE tenant = ?"
                                              : "SELECT count(*) FROM revisions WHERE tenant = ?"));
  const bool row = query.Bind(profile.tenant).Next();
  const int64_t count = row ? query.Int(0) : 0;
  const int64_t bytes = row && table_.max_bytes > 0 ? query.Int(1) : 0;
  if (!query.status().ok()) return query.status();
  if (count >= table_.max_revisions)
    return LimitError(Reason::kRequestTooLarge, fmt::format("revisions of all {}s", table_.what),
                      table_.max_revisions, count + 1);
  const int64_t all = bytes + std::ssize(profile.settings);
  if (table_.max_bytes == 0 || all <= table_.max_bytes) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, fmt::format("bytes of all {}s", table_.what),
                    table_.max_bytes, all);
}

/// Inserts a revision and returns it.
absl::StatusOr<ProfileRecord> SqlProfileStore::Insert(SqlConnection& db, const NewProfile& profile,
                                                      int64_t revision, int64_t now_us) const {
  SqlQuery insert(db, Sql("INSERT INTO revisions (tenant, name, revision, settings,"
                          " settings_digest, create_us) VALUES (?, ?, ?, ?, ?, ?)"));
  insert.Bind(profile.tenant, profile.name, revision, Blob{profile.settings},
              profile.settings_digest, now_us);
  if (absl::Status made = insert.Run(); !made.ok()) return made;
  return ProfileRecord{profile.name, revision, profile.settings, profile.settings_digest, now_us};
}

/// Checks the conditions of a revision, and inserts it. Returns the newest revision instead if it
/// has the same settings. REQUIRES: the transaction has locked the tenant.
absl::StatusOr<ProfileRecord> SqlProfileStore::PutLocked(SqlConnection& db,
                                                         const NewProfile& profile,
                                                         int64_t now_us) const {
  auto newest = Find(db, profile.tenant, profile.name, 0);
  if (!newest.ok()) return newest.status();
  if (*newest && (*newest)->settings_digest == profile.settings_digest) return **std::move(newest);
  const int64_t revision = *newest ? (*newest)->revision : 0;
  if (profile.base && *profile.base != revision) return NotNewest(profile, revision);
  if (absl::Status space = CheckSpace(db, profile); !space.ok()) return space;
  const auto last = LastRevision(db, profile.tenant, profile.name);
  if (!last.ok()) return last.status();
  return Insert(db, profile, *last + 1, now_us);
}

absl::StatusOr<ProfileRecord> SqlProfileStore::Put(const NewProfile& profile, int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlTransaction transaction(**session);
  if (!transaction.status().ok()) return transaction.status();
  if (absl::Status locked = LockTenant(**session, profile.tenant); !locked.ok()) return locked;
  auto stored = PutLocked(**session, profile, now_us);
  if (!stored.ok()) return stored.status();
  if (absl::Status committed = transaction.Commit(); !committed.ok()) return committed;
  return stored;
}

absl::StatusOr<ProfileRecord> SqlProfileStore::Get(const std::string& tenant,
                                                   const std::string& name, int64_t revision) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  auto found = Find(**session, tenant, name, revision);
  if (!found.ok()) return found.status();
  if (!*found) return NotFound(name, revision);
  return **std::move(found);
}

absl::StatusOr<std::vector<ProfileRecord>> SqlProfileStore::List(const std::string& tenant,
                                                                 const std::string& after,
                                                                 int32_t limit) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 Sql("SELECT name, revision, settings_digest, create_us FROM revisions AS p"
                     " WHERE tenant = ? AND name > ? AND revision = (SELECT MAX(revision) FROM"
                     " revisions WHERE tenant = p.tenant AND name = p.name"
                     " AND settings_digest <> '') ORDER BY name LIMIT ?"));
  query.Bind(tenant, after, limit);
  std::vector<ProfileRecord> profiles;
  while (query.Next()) {
    profiles.push_back({query.Text(0), query.Int(1), "", query.Text(2), query.Int(3)});
  }
  if (!query.status().ok()) return query.status();
  return profiles;
}

absl::Status SqlProfileStore::Delete(const std::string& tenant, const std::string& name,
                                     int64_t revision, int64_t now_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlTransaction transaction(**session);
  if (!transaction.status().ok()) return transaction.status();
  if (absl::Status locked = LockTenant(**session, tenant); !locked.ok()) return locked;
  SqlQuery remove(**session,
                  Sql("UPDATE revisions SET settings = ?, settings_digest = '', create_us = ?"
                      " WHERE tenant = ? AND name = ? AND (revision = ? OR ? = 0)"
                      " AND settings_digest <> '' RETURNING revision"));
  remove.Bind(Blob{""}, now_us, tenant, name, revision, revision);
  bool removed = false;
  while (remove.Next()) removed = true;
  if (!remove.status().ok()) return remove.status();
  return removed ? transaction.Commit() : NotFound(name, revision);
}

absl::StatusOr<int64_t> SqlProfileStore::Expire(int64_t before_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlQuery remove(**session,
                  Sql("DELETE FROM revisions WHERE (settings_digest = '' AND create_us < ?) OR"
                      " EXISTS (SELECT 1 FROM revisions AS newer"
                      "  WHERE newer.tenant = revisions.tenant AND newer.name = revisions.name"
                      "  AND newer.revision = revisions.revision + ?"
                      "  AND newer.create_us < ?) RETURNING revision"));
  remove.Bind(before_us, kKeptRevisions, before_us);
  int64_t removed = 0;
  while (remove.Next()) ++removed;
  if (!remove.status().ok()) return remove.status();
  return removed;
}

}  // namespace slicefarm::coordinator
