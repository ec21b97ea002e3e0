#include "tests/load/generator/algo/seeded.h"

#include <fmt/format.h>

namespace slicefarm::load {

SeededRandom SeededRandom::Of(uint64_t seed, uint64_t index) {
  const uint64_t first = SeededRandom(seed).Bits();
  return SeededRandom(SeededRandom(first ^ index).Bits());
}

uint64_t SeededRandom::Bits() {
  state_ += 0x9e3779b97f4a7c15;
  uint64_t z = state_;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

double SeededRandom::Uniform() { return static_cast<double>(Bits() >> 11) * 0x1p-53; }

std::string RequestId(uint64_t seed, uint64_t index) {
  SeededRandom random = SeededRandom::Of(seed, index);
  const uint64_t high = random.Bits();
  const uint64_t low = random.Bits();
  return fmt::format("{:08x}-{:04x}-4{:03x}-{:04x}-{:012x}", high >> 32, (high >> 16) & 0xffff,
                     high & 0xfff, 0x8000 | (low >> 50), low & 0xffffffffffff);
}

}  // namespace slicefarm::load
