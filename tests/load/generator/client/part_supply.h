#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/load/generator/algo/part_maker.h"

namespace slicefarm::load {

/// Mesh file with its digest.
struct Part {
  std::string bytes;
  std::string sha256;
};
using PartPtr = std::shared_ptr<const Part>;

/// Returns a new part.
PartPtr NewPart(PartSize size, uint64_t seed);

/// Options of a PartSupply.
struct PartSupplyOptions {
  Mix mix = Mix::kTiny;
  bool same = false;  ///< true if all parts of a size are equal
  uint64_t seed = 0;
};

/// Makes parts ahead of their use on a thread of its own, so that a request with a large part does
/// not start late. Only one thread at a time may call it.
class PartSupply {
 public:
  explicit PartSupply(const PartSupplyOptions& options);
  ~PartSupply();
  PartSupply(const PartSupply&) = delete;
  PartSupply& operator=(const PartSupply&) = delete;

  /// Returns the next part; waits until it is made.
  PartPtr Take();

  /// Returns one part of each size if all parts of a size are equal; otherwise returns none.
  std::vector<PartPtr> SameParts() const;

 private:
  void MakeParts();
  PartPtr Make(uint64_t index) const;

  const PartSupplyOptions options_;
  std::map<PartSize, PartPtr> same_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<PartPtr> ready_;
  bool closing_ = false;
  std::thread maker_;
};

}  // namespace slicefarm::load
