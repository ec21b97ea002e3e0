#include "services/coordinator/store/faults/database_invariants_test.h"

#include "absl/strings/str_cat.h"
#include "services/coordinator/store/sql/sqlite_connection.h"

namespace slicefarm::coordinator {
namespace {

struct Invariant {
  const char* what;
  const char* violations;  ///< query that must find no row
};

constexpr Invariant kInvariants[] = {
    {"integrity",
     "SELECT integrity_check FROM pragma_integrity_check WHERE integrity_check <> 'ok'"},
    {"foreign keys", "SELECT \"table\" FROM pragma_foreign_key_check"},
    {"a job has all its events",
     "SELECT id FROM jobs AS j WHERE"
     " last_sequence <> (SELECT count(*) FROM events WHERE job = j.number)"
     " OR last_sequence <> (SELECT coalesce(max(sequence), 0) FROM events WHERE job = j.number)"},
    {"the last event is how the job is",
     "SELECT id FROM jobs JOIN events AS e ON e.job = number AND e.sequence = last_sequence"
     " WHERE e.state <> jobs.state OR e.layers_done <> jobs.layers_done"},
    {"a job has all its labels",
     "SELECT id FROM jobs AS j WHERE (SELECT count(*) FROM labels WHERE job = j.number) <>"
     " (SELECT count(*) FROM json_each(j.labels))"},
    {"a request_id has its job",
     "SELECT request_id FROM requests WHERE job_id NOT IN (SELECT id FROM jobs)"},
    {"ended jobs have an end, and a result or an error",
     "SELECT id FROM jobs WHERE (state IN ('SUCCEEDED', 'FAILED', 'CANCELLED') AND end_us = 0)"
     " OR (state = 'SUCCEEDED' AND result = '') OR (state = 'FAILED' AND error = '')"},
    {"a held job has an epoch", "SELECT id FROM jobs WHERE owner <> '' AND owner_epoch = 0"},
};

}  // namespace

std::vector<std::string> DatabaseContradictions(const std::string& path) {
  const auto db = SqliteConnection::Open(path);
  if (!db.ok()) return {db.status().ToString()};
  std::vector<std::string> found;
  for (const Invariant& invariant : kInvariants) {
    SqlQuery query(**db, invariant.violations);
    while (query.Next()) found.push_back(absl::StrCat(invariant.what, ": ", query.Text(0)));
    if (!query.status().ok()) found.push_back(query.status().ToString());
  }
  return found;
}

}  // namespace slicefarm::coordinator
