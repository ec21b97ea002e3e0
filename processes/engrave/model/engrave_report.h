#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace slicefarm {

/// Percentiles of a value over a surface, weighted by area.
struct Spread {
  double p1 = 0;
  double p50 = 0;
  double p99 = 0;

  friend bool operator==(const Spread&, const Spread&) = default;
};

/// Distortion of a surface by its map, and spacing of the lines on the surface.
struct MapReport {
  int64_t faces = 0;
  double area_mm2 = 0;
  double energy_mean = 0;  ///< mean symmetric Dirichlet energy divided by 4: 1 without distortion
  double energy_max = 0;
  /// Ratio of lengths in the map to lengths on the surface, in both principal directions of the
  /// stretching.
  Spread stretch = {};
  Spread line_distance_mm = {};  ///< distance of the first layer's lines on the surface
  /// Share of the first layer's line length with a spacing within 10 % of the setting.
  double line_even = 0;

  friend bool operator==(const MapReport&, const MapReport&) = default;
};

/// Statistics of one layer, without its points.
struct LayerNumbers {
  int32_t layer = 0;  ///< number of the layer, counted from the texture's base
  double height_mm = 0;
  double offset_mm = 0;
  double spacing_mm = 0;
  int64_t runs = 0;
  int64_t points = 0;
  double on_mm = 0;
  double off_mm = 0;
  double section_mm2 = 0;
  /// Number of path segments that change their direction to the opposite when their points are
  /// lifted along the normals.
  int64_t folds = 0;
  double folds_mm = 0;
  Eigen::Vector3d first_fold_mm = Eigen::Vector3d::Zero();

  friend bool operator==(const LayerNumbers&, const LayerNumbers&) = default;
};

/// Totals of a program or of one of its layers.
struct ProgramFacts {
  double seconds = 0;
  double filament_mm = 0;
  int64_t moves = 0;
  Eigen::Vector2d least_deg = Eigen::Vector2d::Zero();  ///< smallest angle of each rotary axis
  Eigen::Vector2d most_deg = Eigen::Vector2d::Zero();

  void Add(const ProgramFacts& other);
  friend bool operator==(const ProgramFacts&, const ProgramFacts&) = default;
};

/// Content of the report of an engraving job.
struct EngraveReport {
  MapReport map;
  std::vector<LayerNumbers> layers;  ///< statistics of each layer; empty: the file has no layers
  ProgramFacts program;              ///< totals of the program; no moves: no program was made
};

/// Returns warnings for the user: uneven line spacing, lifted paths that reverse direction, layers
/// without a line.
std::vector<std::string> WarningsOf(const MapReport& map, const std::vector<LayerNumbers>& layers);

/// Returns the report as JSON: distortion and spacing as p1, p50 and p99, and the height and
/// lengths of each layer.
nlohmann::ordered_json JsonOf(const EngraveReport& report);

}  // namespace slicefarm
