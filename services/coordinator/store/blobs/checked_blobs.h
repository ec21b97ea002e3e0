#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// Set of the blobs that this program has checked against their names. So a blob is hashed only
/// once, not at every Open. When the set is full, it is cleared. Thread-safe.
class CheckedBlobs {
 public:
  /// Properties of a file that change if the blob is written again.
  struct Print {
    int64_t size = 0;
    int64_t written_ns = 0;  ///< time of the last write of the file; 0 if it is unknown

    friend bool operator==(const Print&, const Print&) = default;
  };

  /// Returns true if the blob was checked when its file had this print.
  bool Holds(const std::string& digest, const Print& print) const;
  /// Adds a blob that was checked.
  void Add(const std::string& digest, const Print& print);
  /// Removes a blob.
  void Forget(const std::string& digest);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Print> prints_;
};

}  // namespace slicefarm::coordinator
