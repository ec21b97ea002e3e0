#pragma once

#include <memory>
#include <string>

#include "services/coordinator/store/jobs/webhook_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// WebhookStore in the database of a SqlJobStore.
class SqlWebhookStore : public WebhookStore {
 public:
  explicit SqlWebhookStore(std::shared_ptr<SqlDatabase> database)
      : database_(std::move(database)) {}

  absl::StatusOr<std::optional<DueWebhook>> Claim(int64_t now_us, int64_t until_us,
                                                  const std::set<std::string>& busy = {}) override;
  absl::Status Record(const std::string& job_id, const WebhookAttempt& attempt, WebhookState state,
                      int64_t again_us) override;
  absl::StatusOr<std::optional<WebhookRecord>> Get(const std::string& job_id) override;

 private:
  const std::shared_ptr<SqlDatabase> database_;
};

/// Inserts the webhook of a new job, in a transaction of SqlJobStore. `job`: JobRecord.number.
absl::Status InsertWebhook(SqlConnection& db, int64_t job, const std::string& url);
/// Sets the webhook of an ended job to be sent now, in a transaction of SqlJobStore.
absl::Status MakeWebhookDue(SqlConnection& db, int64_t job, int64_t now_us);

}  // namespace slicefarm::coordinator
