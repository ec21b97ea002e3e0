#include "services/texture/algo/map/thread_random.h"

#include <array>
#include <cstdint>
#include <cstdlib>

namespace slicefarm::texture {
namespace {

/// Random sequence with the parameters of the C library: degree 31.
struct Sequence {
  std::array<char, 128> numbers = {};
  random_data data = {};

  Sequence() { Start(1); }
  void Start(unsigned int seed) {
    data = {};
    initstate_r(seed, numbers.data(), numbers.size(), &data);
  }
};

Sequence& OfThread() {
  thread_local Sequence sequence;
  return sequence;
}

}  // namespace

void SeedThreadRandom(unsigned int seed) { OfThread().Start(seed); }

/// Replacements of C library functions, with the same names.
extern "C" {
__attribute__((visibility("default"))) void SlicefarmThreadSrand(unsigned int seed) __asm__(
    "srand");
__attribute__((visibility("default"))) int SlicefarmThreadRand() __asm__("rand");

void SlicefarmThreadSrand(unsigned int seed) { SeedThreadRandom(seed); }

int SlicefarmThreadRand() {
  int32_t number = 0;
  random_r(&OfThread().data, &number);
  return number;
}
}

}  // namespace slicefarm::texture
