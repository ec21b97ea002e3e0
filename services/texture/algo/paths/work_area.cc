#include "services/texture/algo/paths/work_area.h"

#include <algorithm>

namespace slicefarm::texture {

bool WorkArea::Contains(const Eigen::Vector2d& map_mm) const {
  if (section.Contains(map_mm) == outside) return false;
  if (margin != nullptr && !margin->Contains(map_mm)) return false;
  return std::all_of(masks.begin(), masks.end(),
                     [&](const TiledSection& mask) { return mask.Contains(map_mm); });
}

void WorkArea::Cuts(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                    std::vector<double>* shares) const {
  section.Cuts(a, b, shares);
  if (margin != nullptr) margin->Cuts(a, b, shares);
  for (const TiledSection& mask : masks) mask.Cuts(a, b, shares);
}

bool WorkArea::ContainsAll(const Eigen::Vector2d& a, const Eigen::Vector2d& b) const {
  std::vector<double> shares = {1};
  Cuts(a, b, &shares);
  std::sort(shares.begin(), shares.end());
  double begin = 0;
  for (const double end : shares) {
    if (end > begin && !Contains(a + (begin + end) / 2 * (b - a))) return false;
    begin = end;
  }
  return true;
}

}  // namespace slicefarm::texture
