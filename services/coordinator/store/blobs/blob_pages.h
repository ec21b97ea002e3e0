#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "absl/status/status.h"
#include "services/coordinator/store/blobs/blob_store.h"
#include "services/coordinator/store/sql/sql.h"

namespace slicefarm::coordinator {

/// Calls `visit` for each blob of a tenant that `sql` lists, a page of them a query; no connection
/// is held meanwhile. `sql` begins with `SELECT digest, ... FROM ... WHERE`; what follows it, of
/// the tenant, the last digest and the order, is added. `read` makes an entry of a row.
absl::Status ForEachBlobOf(SqlDatabase& database, std::string_view sql, const std::string& tenant,
                           const std::function<BlobEntry(const SqlQuery&)>& read,
                           const std::function<void(const BlobEntry&)>& visit);

}  // namespace slicefarm::coordinator
