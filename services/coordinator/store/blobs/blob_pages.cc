#include "services/coordinator/store/blobs/blob_pages.h"

#include <vector>

namespace slicefarm::coordinator {
namespace {

constexpr int32_t kPage = 25'000;

}  // namespace

absl::Status ForEachBlobOf(SqlDatabase& database, std::string_view sql, const std::string& tenant,
                           const std::function<BlobEntry(const SqlQuery&)>& read,
                           const std::function<void(const BlobEntry&)>& visit) {
  const std::string of_page =
      std::string(sql) + " tenant = ? AND digest > ? ORDER BY digest LIMIT ?";
  std::string after;
  for (bool more = true; more;) {
    std::vector<BlobEntry> page;
    {
      const auto session = database.Read();
      if (!session.ok()) return session.status();
      SqlQuery query(**session, of_page);
      query.Bind(tenant, after, kPage);
      while (query.Next()) page.push_back(read(query));
      if (!query.status().ok()) return query.status();
    }
    for (const BlobEntry& entry : page) visit(entry);
    more = static_cast<int32_t>(page.size()) == kPage;
    if (more) after = page.back().digest;
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
