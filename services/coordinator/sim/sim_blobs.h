#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace slicefarm::coordinator::sim {

/// The blob store: of each blob, that it is there, and when it was last used.
class SimBlobs {
 public:
  /// Put, or finished again.
  void Put(const std::string& digest, int64_t now_us) { used_us_[digest] = now_us; }

  bool Has(const std::string& digest) const { return used_us_.contains(digest); }

  /// It counts as used; false: it is not there.
  bool Keep(const std::string& digest, int64_t now_us) {
    const auto found = used_us_.find(digest);
    if (found == used_us_.end()) return false;
    found->second = now_us;
    return true;
  }

  /// False: it was used later than that.
  bool Delete(const std::string& digest, int64_t used_before_us) {
    const auto found = used_us_.find(digest);
    if (found == used_us_.end() || found->second > used_before_us) return false;
    used_us_.erase(found);
    return true;
  }

  const std::map<std::string, int64_t>& used_us() const { return used_us_; }

 private:
  std::map<std::string, int64_t> used_us_;
};

}  // namespace slicefarm::coordinator::sim
