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

/// A mesh file and the name it goes by.
struct Part {
  std::string bytes;
  std::string sha256;
};
using PartPtr = std::shared_ptr<const Part>;

PartPtr NewPart(PartSize size, uint64_t seed);

struct PartSupplyOptions {
  Mix mix = Mix::kTiny;
  bool same = false;  ///< of each size always the same part
  uint64_t seed = 0;
};

/// Makes parts ahead of their use in a thread of its own, so that a request does not start late
/// because its part is large. For one caller at a time.
class PartSupply {
 public:
  explicit PartSupply(const PartSupplyOptions& options);
  ~PartSupply();
  PartSupply(const PartSupply&) = delete;
  PartSupply& operator=(const PartSupply&) = delete;

  /// The next part; waits if it is not made yet.
  PartPtr Take();

  /// If always the same parts are taken: one of each size. Else none.
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
