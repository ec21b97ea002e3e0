#include "services/load/algo/poisson_arrivals.h"

#include <cmath>

namespace slicefarm::load {

int64_t PoissonArrivals::NextNs() {
  at_s_ -= std::log1p(-random_.Uniform()) / rate_rps_;
  return std::llround(at_s_ * 1e9);
}

}  // namespace slicefarm::load
