#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <string>

namespace slicefarm::coordinator::sim {

/// Tenant and digest of a blob. Each tenant has its own meshes. Results have no tenant, as in a
/// farm with shared results, so that the same work of two tenants is done once.
struct BlobKey {
  std::string tenant;
  std::string digest;

  friend auto operator<=>(const BlobKey&, const BlobKey&) = default;
};

/// Simulated blob stores. They contain only the existence of each blob and the time of its last
/// use.
class SimBlobs {
 public:
  /// Records a Put or a repeated Finish of a blob.
  void Put(const BlobKey& key, int64_t now_us) { used_us_[key] = now_us; }

  /// Returns true if the blob exists.
  bool Has(const BlobKey& key) const { return used_us_.contains(key); }

  /// Marks a blob as used. Returns false if it does not exist.
  bool Keep(const BlobKey& key, int64_t now_us) {
    const auto found = used_us_.find(key);
    if (found == used_us_.end()) return false;
    found->second = now_us;
    return true;
  }

  /// Deletes a blob. Returns false and keeps the blob if it was used after `used_before_us`.
  bool Delete(const BlobKey& key, int64_t used_before_us) {
    const auto found = used_us_.find(key);
    if (found == used_us_.end() || found->second > used_before_us) return false;
    used_us_.erase(found);
    return true;
  }

  /// Returns the time of the last use of each blob.
  const std::map<BlobKey, int64_t>& used_us() const { return used_us_; }

 private:
  std::map<BlobKey, int64_t> used_us_;
};

}  // namespace slicefarm::coordinator::sim
