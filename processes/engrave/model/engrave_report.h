#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace slicefarm {

/// A spread of values over a surface, by its area.
struct Spread {
  double p1 = 0;
  double p50 = 0;
  double p99 = 0;

  friend bool operator==(const Spread&, const Spread&) = default;
};

/// How the map distorts the surface, and how far apart its lines lie on it.
struct MapReport {
  int64_t faces = 0;
  double area_mm2 = 0;
  double energy_mean = 0;  ///< symmetric Dirichlet over 4: 1 without distortion
  double energy_max = 0;
  Spread stretch = {};  ///< lengths in the map to lengths on the surface, both main directions
  Spread line_distance_mm = {};  ///< on the surface, of the first layer's lines
  double line_even = 0;          ///< share of these lines' length within 10 % of the spacing

  friend bool operator==(const MapReport&, const MapReport&) = default;
};

/// A layer's numbers, without its points.
struct LayerNumbers {
  int32_t layer = 0;  ///< from the texture's base
  double height_mm = 0;
  double offset_mm = 0;
  double spacing_mm = 0;
  int64_t runs = 0;
  int64_t points = 0;
  double on_mm = 0;
  double off_mm = 0;
  double section_mm2 = 0;
  int64_t folds = 0;  ///< ways whose lift turns them back
  double folds_mm = 0;
  Eigen::Vector3d first_fold_mm = Eigen::Vector3d::Zero();

  friend bool operator==(const LayerNumbers&, const LayerNumbers&) = default;
};

/// What a program comes to, or a layer of it.
struct ProgramFacts {
  double seconds = 0;
  double filament_mm = 0;
  int64_t moves = 0;
  Eigen::Vector2d least_deg = Eigen::Vector2d::Zero();  ///< of the angles
  Eigen::Vector2d most_deg = Eigen::Vector2d::Zero();

  void Add(const ProgramFacts& other);
  friend bool operator==(const ProgramFacts&, const ProgramFacts&) = default;
};

/// What a report of an engraving tells.
struct EngraveReport {
  MapReport map;
  std::vector<LayerNumbers> layers;  ///< none: the file has no layers
  ProgramFacts program;  ///< no moves: no program was made
};

/// Returns what a user should know: lines that lie unevenly, lifts that turn back, layers without a
/// line.
std::vector<std::string> WarningsOf(const MapReport& map, const std::vector<LayerNumbers>& layers);

/// Distortion and spacing with p1, p50 and p99, each layer's height and lengths.
nlohmann::ordered_json JsonOf(const EngraveReport& report);

}  // namespace slicefarm
