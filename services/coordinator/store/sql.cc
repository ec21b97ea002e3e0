#include "services/coordinator/store/sql.h"

namespace slicefarm::coordinator {

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
