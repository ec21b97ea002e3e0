#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace slicefarm::coordinator {

/// Which blobs this process has checked against their names, so that each is hashed once and not
/// whenever it is opened. Bounded: when it is full, it forgets all. Thread-safe.
class CheckedBlobs {
 public:
  /// What must be the same for a blob to be the one that was checked.
  struct Print {
    int64_t size = 0;
    int64_t written_ns = 0;  ///< when the file was last written; 0 where nobody can tell

    friend bool operator==(const Print&, const Print&) = default;
  };

  bool Holds(const std::string& digest, const Print& print) const;
  void Add(const std::string& digest, const Print& print);
  void Forget(const std::string& digest);

 private:
  mutable std::mutex mutex_;
  std::map<std::string, Print> prints_;
};

}  // namespace slicefarm::coordinator
