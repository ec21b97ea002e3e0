#include "services/coordinator/store/sql/sql.h"

#include <string>

#include "common/base/error.h"
#include "common/rpc/status_mapping.h"

namespace slicefarm::coordinator {

absl::Status StoreAway(std::string_view why) {
  return MakeError(absl::StatusCode::kUnavailable, Reason::kStoreFailed, std::string(why),
                   {{rpc::kRetryAfterMs, "1000"}});
}

absl::Status SqlQuery::Run() {
  while (Next()) {
  }
  return status();
}

SqlTransaction::SqlTransaction(SqlConnection& connection) : connection_(connection) {
  status_ = SqlQuery(connection_, connection_.dialect().begin).Run();
  open_ = status_.ok();
}

SqlTransaction::~SqlTransaction() {
  if (open_) SqlQuery(connection_, "ROLLBACK").Run().IgnoreError();
}

absl::Status SqlTransaction::Commit() {
  absl::Status committed = SqlQuery(connection_, "COMMIT").Run();
  open_ = !committed.ok();
  return committed;
}

}  // namespace slicefarm::coordinator
