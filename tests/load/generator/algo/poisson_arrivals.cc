#include "tests/load/generator/algo/poisson_arrivals.h"

#include <cmath>

#include "common/base/portable_math.h"

namespace slicefarm::load {

int64_t PoissonArrivals::NextNs() {
  at_s_ -= Log1p(-random_.Uniform()) / rate_rps_;
  return std::llround(at_s_ * 1e9);
}

}  // namespace slicefarm::load
