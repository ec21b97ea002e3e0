#include "services/infill/algo/quality/line_bead.h"

#include <cmath>
#include <numbers>

#include "common/model/bead_section.h"
#include "services/infill/algo/lines/line_flow.h"

namespace slicefarm::infill {
namespace {

/// Distance between the edges of the round strands of thick bridges, in nm. Strands sag, and would
/// otherwise touch.
constexpr double kThreadGapNm = 50'000;

}  // namespace

LineBead SparseBead(Coord width_nm, Coord height_nm, double flow, double density) {
  if (density == 1) return {width_nm, flow};
  const auto spacing_nm = static_cast<double>(Spacing(width_nm, height_nm));
  return {WidthForSpacing(std::llround(spacing_nm / density), height_nm), flow * density};
}

LineBead ThreadBead(Coord nozzle_nm, Coord height_nm, double flow, double density) {
  const double thread_nm = static_cast<double>(nozzle_nm) * std::sqrt(flow);
  const double spacing_nm = (thread_nm + kThreadGapNm) / density;
  const double full_nm2 = spacing_nm * static_cast<double>(height_nm);
  return {WidthForSpacing(std::llround(spacing_nm), height_nm),
          std::numbers::pi / 4 * thread_nm * thread_nm / full_nm2};
}

void ScaleSections(double share, Coord from_nm, Coord to_nm, std::vector<Path>& paths) {
  if (share == 1 && from_nm == to_nm) return;
  for (Path& path : paths)
    for (Coord& width : path.widths_nm) width = WidthFor(share, width, from_nm, to_nm);
}

}  // namespace slicefarm::infill
