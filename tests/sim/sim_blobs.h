#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>

namespace slicefarm::coordinator::sim {

/// Whose blob, and which. Meshes are each tenant's own; results go without a name, as where tenants
/// share them, so that the same work of two tenants is done once.
struct BlobKey {
  std::string tenant;
  std::string digest;

  friend auto operator<=>(const BlobKey&, const BlobKey&) = default;
};

/// The blob stores: of each blob, that it is there, and when it was last used.
class SimBlobs {
 public:
  /// Put, or finished again.
  void Put(const BlobKey& key, int64_t now_us) { used_us_[key] = now_us; }

  bool Has(const BlobKey& key) const { return used_us_.contains(key); }

  /// It counts as used; false: it is not there.
  bool Keep(const BlobKey& key, int64_t now_us) {
    const auto found = used_us_.find(key);
    if (found == used_us_.end()) return false;
    found->second = now_us;
    return true;
  }

  /// False: it was used later than that.
  bool Delete(const BlobKey& key, int64_t used_before_us) {
    const auto found = used_us_.find(key);
    if (found == used_us_.end() || found->second > used_before_us) return false;
    used_us_.erase(found);
    return true;
  }

  const std::map<BlobKey, int64_t>& used_us() const { return used_us_; }

 private:
  std::map<BlobKey, int64_t> used_us_;
};

}  // namespace slicefarm::coordinator::sim
