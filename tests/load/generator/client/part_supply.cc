#include "tests/load/generator/client/part_supply.h"

#include <utility>

#include "common/base/sha256.h"
#include "common/model/scene/scene.h"
#include "tests/load/generator/algo/seeded.h"

namespace slicefarm::load {
namespace {

/// Number of parts that are made ahead. A huge part has 25 MB.
constexpr size_t kPartsAhead = 8;

std::vector<PartSize> SizesOf(Mix mix) {
  switch (mix) {
    case Mix::kTiny:
      return {PartSize::kTiny};
    case Mix::kMedium:
      return {PartSize::kMedium};
    case Mix::kHuge:
      return {PartSize::kHuge};
    case Mix::kMixed:
      break;
  }
  return {PartSize::kTiny, PartSize::kMedium, PartSize::kHuge};
}

}  // namespace

PartPtr NewPart(PartSize size, uint64_t seed) {
  std::string bytes = MakePart(size, seed);
  std::string sha256 = Sha256Hex(bytes);
  return std::make_shared<const Part>(Part{std::move(bytes), std::move(sha256)});
}

PartSupply::PartSupply(const PartSupplyOptions& options) : options_(options) {
  if (options_.same) {
    for (const PartSize size : SizesOf(options_.mix)) same_[size] = NewPart(size, options_.seed);
  }
  maker_ = std::thread([this] { MakeParts(); });
}

PartSupply::~PartSupply() {
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
  }
  changed_.notify_all();
  maker_.join();
}

PartPtr PartSupply::Take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !ready_.empty(); });
  PartPtr part = std::move(ready_.front());
  ready_.pop_front();
  changed_.notify_all();
  return part;
}

std::vector<PartPtr> PartSupply::SameParts() const {
  std::vector<PartPtr> parts;
  for (const auto& [size, part] : same_) parts.push_back(part);
  return parts;
}

PartPtr PartSupply::Make(uint64_t index) const {
  const PartSize size = PickSize(options_.mix, options_.seed, index);
  if (options_.same) return same_.at(size);
  return NewPart(size, SeededRandom::Of(options_.seed, index).Bits());
}

void PartSupply::MakeParts() {
  for (uint64_t index = 0;; ++index) {
    PartPtr part = Make(index);
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return closing_ || ready_.size() < kPartsAhead; });
    if (closing_) return;
    ready_.push_back(std::move(part));
    changed_.notify_all();
  }
}

}  // namespace slicefarm::load
