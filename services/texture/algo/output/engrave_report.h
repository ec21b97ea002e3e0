#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "absl/status/statusor.h"
#include "common/base/cancel_token.h"
#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {

/// A spread of values over a surface, by its area.
struct Spread {
  double p1 = 0;
  double p50 = 0;
  double p99 = 0;
};

/// REQUIRES: as many values as weights, at least one. Cost: O(n log n).
Spread SpreadOf(const std::vector<double>& values, const std::vector<double>& weights);

/// How the map distorts the surface, and how far apart its lines lie on it.
struct MapReport {
  int64_t faces = 0;
  double area_mm2 = 0;
  double energy_mean = 0;  ///< symmetric Dirichlet over 4: 1 without distortion
  double energy_max = 0;
  Spread stretch = {};  ///< lengths in the map to lengths on the surface, both main directions
  Spread line_distance_mm = {};  ///< on the surface, of the first layer's lines
  double line_even = 0;          ///< share of these lines' length within 10 % of the spacing
};

absl::StatusOr<MapReport> MapReportOf(const EngravePlan& plan, const CancelToken& cancel = {});

/// A layer's numbers, without its points.
struct LayerNumbers {
  int32_t layer = 0;
  double height_mm = 0;
  double offset_mm = 0;
  double spacing_mm = 0;
  int64_t runs = 0;
  int64_t points = 0;
  double on_mm = 0;
  double off_mm = 0;
  double section_mm2 = 0;
  int64_t folds = 0;
  double folds_mm = 0;
  Eigen::Vector3d first_fold_mm = Eigen::Vector3d::Zero();

  friend bool operator==(const LayerNumbers&, const LayerNumbers&) = default;
};

LayerNumbers NumbersOf(const LayerPath& path);

/// What a user should know of it: lines that lie unevenly, lifts that turn back, nothing to work.
std::vector<std::string> WarningsOf(const MapReport& map, const std::vector<LayerNumbers>& layers);

}  // namespace slicefarm::texture
