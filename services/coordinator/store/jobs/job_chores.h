#pragma once

#include <cstdint>
#include <string>

#include "absl/status/statusor.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Implements JobStore::TakeChore in SQL, with the table `chores`.
absl::StatusOr<bool> TakeChore(SqlConnection& db, const std::string& chore, int64_t now_us,
                               int64_t until_us);
/// Implements JobStore::InUseSince in SQL, with the table `chores`.
absl::StatusOr<int64_t> InUseSince(SqlConnection& db, int64_t now_us, int64_t most_gap_us);

}  // namespace slicefarm::coordinator
