#include "services/texture/algo/map/exact_turn.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "common/geometry/point.h"

namespace slicefarm::texture {

int ExactTurn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  return CGAL::orientation(Point(a.x(), a.y()), Point(b.x(), b.y()), Point(c.x(), c.y()));
}

}  // namespace slicefarm::texture
