#include "services/beading/algo/strategy/bead_layout.h"

namespace slicefarm::beading {

Beading LayOut(Coord thickness_nm, int count, const std::vector<Coord>& half_widths_nm) {
  Beading beading;
  beading.thickness_nm = thickness_nm;
  beading.left_over_nm = thickness_nm;
  beading.widths_nm.resize(count);
  beading.locations_nm.resize(count);
  Coord covered = 0;
  for (int i = 0; i < count / 2; ++i) {
    const int mirrored = count - 1 - i;
    beading.widths_nm[i] = beading.widths_nm[mirrored] = half_widths_nm[i];
    beading.locations_nm[i] = covered + half_widths_nm[i] / 2;
    beading.locations_nm[mirrored] = thickness_nm - beading.locations_nm[i];
    covered += half_widths_nm[i];
    beading.left_over_nm -= 2 * half_widths_nm[i];
  }
  if (count % 2 == 1) {
    beading.widths_nm[count / 2] = half_widths_nm[count / 2];
    beading.locations_nm[count / 2] = thickness_nm / 2;
    beading.left_over_nm -= half_widths_nm[count / 2];
  }
  return beading;
}

}  // namespace slicefarm::beading
