#include "services/coordinator/store/blobs/checked_blobs.h"

namespace slicefarm::coordinator {
namespace {

/// Largest number of remembered blobs; some 10 MB.
constexpr size_t kMostChecked = 65'536;

}  // namespace

bool CheckedBlobs::Holds(const std::string& digest, const Print& print) const {
  const std::lock_guard lock(mutex_);
  const auto found = prints_.find(digest);
  return found != prints_.end() && found->second == print;
}

void CheckedBlobs::Add(const std::string& digest, const Print& print) {
  const std::lock_guard lock(mutex_);
  if (prints_.size() >= kMostChecked) prints_.clear();
  prints_[digest] = print;
}

void CheckedBlobs::Forget(const std::string& digest) {
  const std::lock_guard lock(mutex_);
  prints_.erase(digest);
}

}  // namespace slicefarm::coordinator
