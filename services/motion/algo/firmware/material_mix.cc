#include "services/motion/algo/firmware/material_mix.h"

#include <cmath>

namespace slicefarm::motion {

void MaterialMix::SetFor(const PositionMm& position_mm, GcodeText& out) {
  if (field_ == nullptr) return;
  std::vector<double> shares;
  bool changed = written_.empty();
  for (const DensityField& part : field_->parts) {
    const double share = part.At(position_mm, 0);
    changed = changed || std::abs(share - written_[shares.size()]) > field_->step;
    shares.push_back(share);
  }
  if (!changed) return;
  firmware_.WriteMix(shares, out);
  written_ = std::move(shares);
}

}  // namespace slicefarm::motion
