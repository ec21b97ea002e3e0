#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <limits>

namespace slicefarm::texture {

/// Undistorted shape of a triangle in the plane. The distortion of a map is measured from it.
struct RestTriangle {
  /// Inverse of the matrix with columns p1-p0 and p2-p0.
  Eigen::Matrix2d inverse_edges = Eigen::Matrix2d::Identity();
  double area = 0;
};

/// Returns the undistorted shape of a triangle in space: the triangle laid flat with its first edge
/// along x. REQUIRES: the triangle has an area.
RestTriangle RestOf(const Eigen::Vector3d& p0, const Eigen::Vector3d& p1,
                    const Eigen::Vector3d& p2);
/// Returns the undistorted shape of a triangle in the plane. REQUIRES: the corners are
/// counter-clockwise.
RestTriangle RestOf(const Eigen::Vector2d& p0, const Eigen::Vector2d& p1,
                    const Eigen::Vector2d& p2);
/// Returns an equilateral triangle with the area `area`.
RestTriangle EquilateralRest(double area);

/// Returns the Jacobian of the linear map from the undistorted triangle to the triangle u0, u1, u2.
inline Eigen::Matrix2d JacobianOf(const RestTriangle& rest, const Eigen::Vector2d& u0,
                                  const Eigen::Vector2d& u1, const Eigen::Vector2d& u2) {
  Eigen::Matrix2d edges;
  edges << u1 - u0, u2 - u0;
  return edges * rest.inverse_edges;
}

/// Returns the symmetric Dirichlet energy |J|^2 + |J^-1|^2. It is 4 for an isometry. It is infinite
/// for the Jacobian of a flat or flipped triangle.
inline double SymmetricDirichlet(const Eigen::Matrix2d& jacobian) {
  const double det = jacobian.determinant();
  if (!(det > 0)) return std::numeric_limits<double>::infinity();
  return jacobian.squaredNorm() * (1 + 1 / (det * det));
}

/// Quadratic model of a triangle's energy: its gradient and a positive semi-definite Hessian, with
/// respect to the corners' coordinates (x0 y0 x1 y1 x2 y2).
struct LocalModel {
  Eigen::Matrix<double, 6, 1> gradient = Eigen::Matrix<double, 6, 1>::Zero();
  Eigen::Matrix<double, 6, 6> hessian = Eigen::Matrix<double, 6, 6>::Zero();
};

/// Returns the model of the symmetric Dirichlet energy. The exact Hessian may have one negative
/// eigenvalue (twisting), which is replaced by 0. The model is also exact for conformal maps.
/// REQUIRES: det J > 0.
///
/// Source: Smith, de Goes, Kim, "Analytic Eigensystems for Isotropic Distortion Energies", ACM TOG
/// 38 (2019).
LocalModel ModelOf(const Eigen::Matrix2d& jacobian, const RestTriangle& rest);

/// Returns a model with the gradient of ModelOf and another Hessian: the Hessian of the squared
/// distance to the nearest rotation, weighted to match the gradient. Far from the undistorted
/// shape, this model gives longer steps than ModelOf.
///
/// Source: Rabinovich et al., "Scalable Locally Injective Mappings", ACM TOG 36 (2017).
LocalModel ProxyOf(const Eigen::Matrix2d& jacobian, const RestTriangle& rest);

/// Returns a shape between `rest` and the triangle's present shape. Measured from the returned
/// shape, the energy of each of the two stretches is at most half of `bound`. REQUIRES: det J > 0,
/// bound >= 4.
RestTriangle NearerRest(const RestTriangle& rest, const Eigen::Matrix2d& jacobian, double bound);

}  // namespace slicefarm::texture
