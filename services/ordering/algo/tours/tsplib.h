#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "absl/status/statusor.h"
#include "services/ordering/algo/tours/costs.h"
#include "services/ordering/algo/tours/tour_rules.h"

namespace slicefarm::ordering {

/// Problem of a TSPLIB file.
struct TspInstance {
  std::string name;
  Costs costs;
  std::vector<NodePair> fixed;  ///< open chains, or one ring of all nodes
};

inline constexpr int32_t kMaxPoints = 20'000;
inline constexpr int32_t kMostTableNodes = 5'000;  ///< a table has n * n numbers
/// largest absolute weight and coordinate, so that sums are exact
inline constexpr double kGreatestWeight = 1e9;

/// Reads a symmetric instance in the format of TSPLIB 95. Node k of the file becomes node k - 1.
///
/// EDGE_WEIGHT_TYPE: EUC_2D, CEIL_2D, ATT, GEO, or EXPLICIT as FULL_MATRIX, UPPER_ROW, LOWER_ROW,
/// UPPER_DIAG_ROW or LOWER_DIAG_ROW; with or without FIXED_EDGES_SECTION. Errors: REQUEST_MALFORMED
/// with the line number, including for unsupported TSPLIB features; REQUEST_TOO_LARGE above
/// kMaxPoints or kMostTableNodes. Source: G. Reinelt, "TSPLIB 95", Heidelberg 1995.
absl::StatusOr<TspInstance> ReadTsplib(std::string_view text);

/// Returns the text of a TSPLIB file of TYPE TOUR.
std::string PrintTour(const std::string& name, const Tour& tour);

}  // namespace slicefarm::ordering
