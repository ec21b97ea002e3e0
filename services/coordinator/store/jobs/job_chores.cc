#include "services/coordinator/store/jobs/job_chores.h"

#include <map>
#include <utility>

namespace slicefarm::coordinator {
namespace {

// Names of two rows in `chores` that contain the time of use instead of a chore. deploy/restore.sh
// deletes them.
constexpr char kUseBegin[] = "use_begin";
constexpr char kUseLast[] = "use_last";

/// Returns the times of both rows by their names. Errors: errors of the database.
absl::StatusOr<std::map<std::string, int64_t>> UseOf(SqlConnection& db) {
  std::map<std::string, int64_t> use;
  SqlQuery ask(db, "SELECT name, until_us FROM chores WHERE name IN (?, ?)");
  ask.Bind(kUseBegin, kUseLast);
  while (ask.Next()) use[ask.Text(0)] = ask.Int(1);
  if (!ask.status().ok()) return ask.status();
  return use;
}

absl::Status Put(SqlConnection& db, const char* name, int64_t time_us) {
  SqlQuery put(db,
               "INSERT INTO chores (name, until_us) VALUES (?, ?)"
               " ON CONFLICT (name) DO UPDATE SET until_us = excluded.until_us");
  return put.Bind(name, time_us).Run();
}

}  // namespace

absl::StatusOr<bool> TakeChore(SqlConnection& db, const std::string& chore, int64_t now_us,
                               int64_t until_us) {
  SqlQuery take(db,
                "INSERT INTO chores (name, until_us) VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET"
                " until_us = excluded.until_us WHERE chores.until_us <= ? RETURNING name");
  take.Bind(chore, until_us, now_us);
  bool taken = false;
  while (take.Next()) taken = true;
  if (!take.status().ok()) return take.status();
  return taken;
}

absl::StatusOr<int64_t> InUseSince(SqlConnection& db, int64_t now_us, int64_t most_gap_us) {
  SqlTransaction transaction(db);
  if (!transaction.status().ok()) return transaction.status();
  const auto use = UseOf(db);
  if (!use.ok()) return use.status();
  const bool goes_on = use->size() == 2 && now_us - use->at(kUseLast) <= most_gap_us;
  const int64_t begin_us = goes_on ? use->at(kUseBegin) : now_us;
  if (absl::Status put = Put(db, kUseBegin, begin_us); !put.ok()) return put;
  if (absl::Status put = Put(db, kUseLast, now_us); !put.ok()) return put;
  if (absl::Status committed = transaction.Commit(); !committed.ok()) return committed;
  return begin_us;
}

}  // namespace slicefarm::coordinator
