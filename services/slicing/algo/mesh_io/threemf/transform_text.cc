#include "services/slicing/algo/mesh_io/threemf/transform_text.h"

#include <Eigen/LU>
#include <cmath>
#include <optional>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "services/slicing/algo/mesh_io/text_lines.h"
#include "services/slicing/algo/mesh_io/threemf/package/xml.h"

namespace slicefarm::slicing::threemf {

absl::Status CheckTransform(const Transform& transform) {
  // Smallest accepted volume of the box that three vectors of length 1 span. With a smaller volume,
  // the vectors are in one plane except for rounding.
  constexpr double kFlattest = 1e-9;
  if (!transform.array().isFinite().all())
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kMeshNotFinite,
                     "a transform has a number that is not finite");
  if (transform.cwiseAbs().maxCoeff() > limits::kMaxTransformEntry)
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                     "a transform has a number beyond a million");
  const Eigen::Matrix3d linear = transform.leftCols<3>();
  const double edges = linear.colwise().norm().prod();
  if (!(std::abs(linear.determinant()) > kFlattest * edges))
    return Malformed("a transform that makes everything flat");
  return absl::OkStatus();
}

absl::StatusOr<Transform> ParseTransform(std::string_view text, double unit_mm) {
  Words words(text);
  Transform transform;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      const std::optional<double> number = ParseNumber(words.Next());
      if (!number) return Malformed("a transform must have twelve numbers");
      transform(row, column) = *number;
    }
  }
  if (!words.Next().empty()) return Malformed("a transform must have twelve numbers");
  transform.col(3) *= unit_mm;
  if (absl::Status status = CheckTransform(transform); !status.ok()) return status;
  return transform;
}

Transform Composed(const Transform& outer, const Transform& inner) {
  Transform both;
  both.leftCols<3>() = outer.leftCols<3>() * inner.leftCols<3>();
  both.col(3) = outer.leftCols<3>() * inner.col(3) + outer.col(3);
  return both;
}

}  // namespace slicefarm::slicing::threemf
