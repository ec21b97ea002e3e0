#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Calls `visit` for each blob of a tenant that `sql` lists. Reads one page of rows per query, and
/// uses no connection during the visits. `sql` has the form `SELECT digest, ... FROM ... WHERE`;
/// the function appends the conditions for the tenant and for the next page, and the order. `read`
/// converts a row to an entry. Errors: see SqlDatabase.
absl::Status ForEachBlobOf(SqlDatabase& database, std::string_view sql, const std::string& tenant,
                           const std::function<BlobEntry(const SqlQuery&)>& read,
                           const std::function<void(const BlobEntry&)>& visit);

}  // namespace slicefarm::coordinator
