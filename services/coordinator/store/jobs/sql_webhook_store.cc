#include "services/coordinator/store/jobs/sql_webhook_store.h"

#include <array>
#include <utility>

#include "absl/strings/str_cat.h"
#include "common/base/error.h"

namespace slicefarm::coordinator {
namespace {

constexpr std::array<std::string_view, 4> kStates = {"WAITING", "DUE", "DELIVERED", "GIVEN_UP"};

std::string_view NameOf(WebhookState state) { return kStates[static_cast<size_t>(state)]; }

absl::StatusOr<WebhookState> StateOf(const std::string& name) {
  for (size_t i = 0; i < kStates.size(); ++i)
    if (kStates[i] == name) return static_cast<WebhookState>(i);
  return MakeError(absl::StatusCode::kDataLoss, Reason::kStoreFailed,
                   absl::StrCat("a webhook has the state ", name));
}

/// Returns true if a webhook is due. Most checks find none and need no write transaction.
absl::StatusOr<bool> AnyDue(SqlDatabase& database, int64_t now_us) {
  const auto session = database.Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session, "SELECT 1 FROM webhooks WHERE state = 'DUE' AND due_us <= ? LIMIT 1");
  const bool any = query.Bind(now_us).Next();
  if (!query.status().ok()) return query.status();
  return any;
}

}  // namespace

absl::StatusOr<std::optional<DueWebhook>> SqlWebhookStore::Claim(
    int64_t now_us, int64_t until_us, const std::set<std::string>& busy) {
  const auto any = AnyDue(*database_, now_us);
  if (!any.ok()) return any.status();
  if (!*any) return std::nullopt;
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  std::string others;
  for (size_t i = 0; i < busy.size(); ++i)
    others += " AND (SELECT tenant FROM jobs WHERE number = webhooks.job) <> ?";
  SqlQuery claim(**session,
                 absl::StrCat("UPDATE webhooks SET due_us = ?, attempts = attempts + 1"
                              " WHERE job = (SELECT job FROM webhooks WHERE state = 'DUE'"
                              " AND due_us <= ?",
                              others, " ORDER BY due_us LIMIT 1",
                              std::string((*session)->dialect().skip_locked),
                              ") RETURNING url, attempts,"
                              " (SELECT id FROM jobs WHERE number = webhooks.job),"
                              " (SELECT tenant FROM jobs WHERE number = webhooks.job)"));
  claim.Bind(until_us, now_us);
  for (const std::string& tenant : busy) claim.Bind(tenant);
  std::optional<DueWebhook> due;
  while (claim.Next()) {
    due = DueWebhook{.job_id = claim.Text(2),
                     .tenant = claim.Text(3),
                     .url = claim.Text(0),
                     .attempt = static_cast<int32_t>(claim.Int(1))};
  }
  if (!claim.status().ok()) return claim.status();
  return due;
}

absl::Status SqlWebhookStore::Record(const std::string& job_id, const WebhookAttempt& attempt,
                                     WebhookState state, int64_t again_us) {
  const auto session = database_->Write();
  if (!session.ok()) return session.status();
  SqlTransaction transaction(**session);
  if (!transaction.status().ok()) return transaction.status();
  SqlQuery log(**session,
               "INSERT INTO webhook_attempts (job, attempt, time_us, http_status, error)"
               " SELECT number, CAST(? AS BIGINT), CAST(? AS BIGINT), CAST(? AS BIGINT), ?"
               " FROM jobs WHERE id = ? ON CONFLICT DO NOTHING");
  log.Bind(attempt.attempt, attempt.time_us, attempt.http_status, attempt.error, job_id);
  if (absl::Status done = log.Run(); !done.ok()) return done;
  SqlQuery update(**session,
                  "UPDATE webhooks SET state = ?, due_us = ?"
                  " WHERE job = (SELECT number FROM jobs WHERE id = ?)"
                  " AND state = 'DUE' AND attempts = ?");
  update.Bind(NameOf(state), again_us, job_id, attempt.attempt);
  if (absl::Status done = update.Run(); !done.ok()) return done;
  return transaction.Commit();
}

absl::StatusOr<std::optional<WebhookRecord>> SqlWebhookStore::Get(const std::string& job_id) {
  const auto session = database_->Read();
  if (!session.ok()) return session.status();
  SqlQuery query(**session,
                 "SELECT url, state, due_us, job FROM webhooks"
                 " WHERE job = (SELECT number FROM jobs WHERE id = ?)");
  if (!query.Bind(job_id).Next()) {
    if (!query.status().ok()) return query.status();
    return std::nullopt;
  }
  const auto state = StateOf(query.Text(1));
  if (!state.ok()) return state.status();
  WebhookRecord record{query.Text(0), *state, query.Int(2)};
  SqlQuery log(**session,
               "SELECT attempt, time_us, http_status, error FROM webhook_attempts"
               " WHERE job = ? ORDER BY attempt");
  log.Bind(query.Int(3));
  while (log.Next()) {
    record.attempts.push_back({static_cast<int32_t>(log.Int(0)), log.Int(1),
                               static_cast<int32_t>(log.Int(2)), log.Text(3)});
  }
  if (!log.status().ok()) return log.status();
  return record;
}

absl::Status InsertWebhook(SqlConnection& db, int64_t job, const std::string& url) {
  if (url.empty()) return absl::OkStatus();
  SqlQuery insert(db,
                  "INSERT INTO webhooks (job, url, state, due_us, attempts)"
                  " VALUES (?, ?, 'WAITING', 0, 0)");
  return insert.Bind(job, url).Run();
}

absl::Status MakeWebhookDue(SqlConnection& db, int64_t job, int64_t now_us) {
  SqlQuery update(db, "UPDATE webhooks SET state = 'DUE', due_us = ? WHERE job = ?");
  return update.Bind(now_us, job).Run();
}

}  // namespace slicefarm::coordinator
