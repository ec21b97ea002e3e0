#include "tests/load/generator/algo/seeded.h"

#include <fmt/format.h>

namespace slicefarm::load {

SeededRandom SeededRandom::Of(uint64_t seed, uint64_t index) {
  const uint64_t first = SeededRandom(seed).Bits();
  return SeededRandom(SeededRandom(first ^ index).Bits());
}

std::string RequestId(uint64_t seed, uint64_t index) {
  SeededRandom random = SeededRandom::Of(seed, index);
  const uint64_t high = random.Bits();
  const uint64_t low = random.Bits();
  return fmt::format("{:08x}-{:04x}-4{:03x}-{:04x}-{:012x}", high >> 32, (high >> 16) & 0xffff,
                     high & 0xfff, 0x8000 | (low >> 50), low & 0xffffffffffff);
}

}  // namespace slicefarm::load
