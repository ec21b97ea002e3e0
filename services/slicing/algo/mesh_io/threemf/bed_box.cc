#include "services/slicing/algo/mesh_io/threemf/bed_box.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "common/base/text.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"

namespace slicefarm::slicing::threemf {
namespace {

std::optional<BedBox> ParseBedBox(std::string_view area) {
  std::array<double, 2> least = {INFINITY, INFINITY}, most = {-INFINITY, -INFINITY};
  for (const std::string_view corner : Split(area, "[]\", ")) {
    const size_t cross = corner.find('x');
    if (cross == std::string_view::npos) continue;
    const std::array<std::optional<double>, 2> at = {ParseNumber(corner.substr(0, cross)),
                                                     ParseNumber(corner.substr(cross + 1))};
    for (size_t axis = 0; axis < 2; ++axis) {
      if (!at[axis]) return std::nullopt;
      least[axis] = std::min(least[axis], *at[axis]);
      most[axis] = std::max(most[axis], *at[axis]);
    }
  }
  const BedBox box = {least, {most[0] - least[0], most[1] - least[1]}};
  const auto good = [](double mm) { return mm > 0 && mm <= limits::kMaxMeshCoordinateMm; };
  return good(box.size[0]) && good(box.size[1]) ? std::optional(box) : std::nullopt;
}

}  // namespace

std::optional<BedBox> BedBoxOf(const std::vector<Setting>& settings, std::string_view key) {
  const auto found = std::ranges::find(settings, key, &Setting::key);
  return found == settings.end() ? std::nullopt : ParseBedBox(found->value);
}

}  // namespace slicefarm::slicing::threemf
