#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Calls `visit` for each blob of a tenant that `sql` lists. Reads one page per query, and holds no
/// connection during the visits. `sql` has the form `SELECT digest, ... FROM ... WHERE`. The
/// function adds the conditions for the tenant and the last digest, and the order. `read` converts
/// a row to an entry.
absl::Status ForEachBlobOf(SqlDatabase& database, std::string_view sql, const std::string& tenant,
                           const std::function<BlobEntry(const SqlQuery&)>& read,
                           const std::function<void(const BlobEntry&)>& visit);

}  // namespace slicefarm::coordinator
