#include "services/infill/algo/quality/fill_plastic.h"

#include <algorithm>

#include "common/model/bead_section.h"

namespace slicefarm::infill {

double PlasticMm3(const Path& path, Coord height_nm) {
  const auto section = [&](size_t from, size_t to) {
    return SectionMm2((path.WidthAt(from) + path.WidthAt(to)) / 2, height_nm);
  };
  if (path.widths_nm.size() == 1) return ToMm(PathLength(path)) * section(0, 0);
  double plastic = 0;
  const size_t count = path.points.size();
  for (size_t i = 1; i < count + (path.closed ? 1 : 0); ++i)
    plastic +=
        ToMm(Distance(path.points[i - 1], path.points[i % count])) * section(i - 1, i % count);
  return plastic;
}

FillStats UseOf(const RequestedFill& asked, std::span<const Path> paths, Coord layer_height_nm) {
  FillStats use;
  use.feature = asked.feature;
  use.pattern = asked.pattern;
  use.area_mm2 = asked.area_nm2 / kNmPerMm / kNmPerMm;
  use.volume_mm3 = use.area_mm2 * ToMm(static_cast<double>(asked.height_nm));
  use.asked_mm3 = asked.share * use.volume_mm3;
  use.paths = std::ssize(paths);
  for (const Path& path : paths) {
    const double length_mm = ToMm(PathLength(path));
    use.plastic_mm3 += PlasticMm3(path, layer_height_nm);
    use.length_mm += length_mm;
    use.longest_mm = std::max(use.longest_mm, length_mm);
  }
  return use;
}

}  // namespace slicefarm::infill
