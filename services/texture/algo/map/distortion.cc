#include "services/texture/algo/map/distortion.h"

#include <algorithm>
#include <cmath>

namespace slicefarm::texture {
namespace {

/// Singular values of J and their directions, as a rotation and a reflection. J is a weighted sum
/// of these two.
struct Stretch {
  double first = 0;  ///< the larger one
  double second = 0;
  Eigen::Matrix2d rotation;    ///< rotation U V^T
  Eigen::Matrix2d reflection;  ///< reflection U diag(1, -1) V^T
};

Stretch StretchOf(const Eigen::Matrix2d& j) {
  const double e = (j(0, 0) + j(1, 1)) / 2, h = (j(1, 0) - j(0, 1)) / 2;
  double f = (j(0, 0) - j(1, 1)) / 2, g = (j(1, 0) + j(0, 1)) / 2;
  const double q = std::sqrt(e * e + h * h);
  const double r = std::sqrt(f * f + g * g);
  Stretch stretch;
  stretch.first = q + r;
  // q - r would lose precision for a thin triangle.
  stretch.second = j.determinant() / stretch.first;
  stretch.rotation << e / q, -h / q, h / q, e / q;
  if (r > 0) {
    f /= r;
    g /= r;
  } else {
    f = 1;
    g = 0;
  }
  stretch.reflection << f, g, g, -f;
  return stretch;
}

RestTriangle RestOfEdges(const Eigen::Matrix2d& edges) {
  return {edges.inverse(), edges.determinant() / 2};
}

/// Returns the gradients of the corners' hat functions on the triangle at rest, one per column.
Eigen::Matrix<double, 2, 3> HatGradients(const RestTriangle& rest) {
  Eigen::Matrix<double, 2, 3> hats;
  hats.col(1) = rest.inverse_edges.row(0);
  hats.col(2) = rest.inverse_edges.row(1);
  hats.col(0) = -hats.col(1) - hats.col(2);
  return hats;
}

/// Returns the derivative of the scalar product <D, J> with respect to the corners' coordinates.
Eigen::Matrix<double, 6, 1> ByCorners(const Eigen::Matrix2d& d,
                                      const Eigen::Matrix<double, 2, 3>& hats) {
  const Eigen::Matrix<double, 2, 3> by_corner = d * hats;
  return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(by_corner.data());
}

}  // namespace

RestTriangle RestOf(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                    const Eigen::Vector3d& p2) {
  const Eigen::Vector3d first = p1 - p0, second = p2 - p0;
  const double length = first.norm();
  Eigen::Matrix2d edges;
  edges << length, first.dot(second) / length, 0, first.cross(second).norm() / length;
  return RestOfEdges(edges);
}

RestTriangle RestOf(const Eigen::Vector2d& p0, const Eigen::Vector2d& p1,
                    const Eigen::Vector2d& p2) {
  Eigen::Matrix2d edges;
  edges << p1 - p0, p2 - p0;
  return RestOfEdges(edges);
}

RestTriangle EquilateralRest(double area) {
  const double side = std::sqrt(4 * area / std::sqrt(3.0));
  Eigen::Matrix2d edges;
  edges << side, side / 2, 0, side * std::sqrt(3.0) / 2;
  return RestOfEdges(edges);
}

LocalModel ModelOf(const Eigen::Matrix2d& jacobian, const RestTriangle& rest) {
  const Stretch s = StretchOf(jacobian);
  const Eigen::Matrix<double, 2, 3> hats = HatGradients(rest);
  const Eigen::Matrix2d first = (s.rotation + s.reflection) / 2;
  const Eigen::Matrix2d second = (s.rotation - s.reflection) / 2;
  const double inv1 = 1 / s.first, inv2 = 1 / s.second;
  const double inv1_3 = inv1 * inv1 * inv1, inv2_3 = inv2 * inv2 * inv2;
  const Eigen::Matrix<double, 6, 1> along1 = ByCorners(first, hats);
  const Eigen::Matrix<double, 6, 1> along2 = ByCorners(second, hats);

  LocalModel model;
  model.gradient = 2 * (s.first - inv1_3) * along1 + 2 * (s.second - inv2_3) * along2;
  model.hessian = (2 + 6 * inv1_3 * inv1) * along1 * along1.transpose() +
                  (2 + 6 * inv2_3 * inv2) * along2 * along2.transpose();
  Eigen::Matrix2d quarter_turn;
  quarter_turn << 0, -1, 1, 0;
  const Eigen::Matrix<double, 6, 1> flip =
      ByCorners(quarter_turn * s.reflection * std::sqrt(0.5), hats);
  const double det_inverse = inv1 * inv2;
  model.hessian += (2 + 2 * (s.first * s.first + s.first * s.second + s.second * s.second) *
                            det_inverse * det_inverse * det_inverse) *
                   flip * flip.transpose();
  const double twisting = 2 - 2 * (inv1_3 + inv2_3) / (s.first + s.second);
  if (twisting > 0) {
    const Eigen::Matrix<double, 6, 1> twist =
        ByCorners(quarter_turn * s.rotation * std::sqrt(0.5), hats);
    model.hessian += twisting * twist * twist.transpose();
  }
  return model;
}

LocalModel ProxyOf(const Eigen::Matrix2d& jacobian, const RestTriangle& rest) {
  const Stretch s = StretchOf(jacobian);
  const Eigen::Matrix<double, 2, 3> hats = HatGradients(rest);
  Eigen::Matrix2d quarter_turn;
  quarter_turn << 0, -1, 1, 0;
  const Eigen::Matrix2d turned_rotation = quarter_turn * s.rotation;
  const Eigen::Matrix2d turned_reflection = quarter_turn * s.reflection;
  const auto weight = [](double stretch) {
    return 2 * (stretch + 1) * (stretch * stretch + 1) / (stretch * stretch * stretch);
  };
  const auto slope = [](double stretch) {
    return 2 * (stretch - 1 / (stretch * stretch * stretch));
  };
  LocalModel model;
  const auto add = [&](double stretch, const Eigen::Matrix2d& along,
                       const Eigen::Matrix2d& across) {
    const Eigen::Matrix<double, 6, 1> a = ByCorners(along, hats), b = ByCorners(across, hats);
    model.gradient += slope(stretch) * a;
    model.hessian += weight(stretch) * (a * a.transpose() + b * b.transpose());
  };
  add(s.first, (s.rotation + s.reflection) / 2, (turned_reflection - turned_rotation) / 2);
  add(s.second, (s.rotation - s.reflection) / 2, (turned_reflection + turned_rotation) / 2);
  return model;
}

RestTriangle NearerRest(const RestTriangle& rest, const Eigen::Matrix2d& jacobian, double bound) {
  const Stretch s = StretchOf(jacobian);
  // Largest allowed stretch x: the energy x^2 + 1 / x^2 is half of the bound, and so it is for 1 /
  // x.
  const double half = bound / 2;
  const double most = std::sqrt((half + std::sqrt(half * half - 4)) / 2);
  const double change1 = std::clamp(s.first, 1 / most, most) / s.first;
  const double change2 = std::clamp(s.second, 1 / most, most) / s.second;
  // This is V diag(1, -1) V^T.
  const Eigen::Matrix2d reflection = s.rotation.transpose() * s.reflection;
  const Eigen::Matrix2d change =
      (change1 + change2) / 2 * Eigen::Matrix2d::Identity() + (change1 - change2) / 2 * reflection;
  return {rest.inverse_edges * change, rest.area};
}

}  // namespace slicefarm::texture
