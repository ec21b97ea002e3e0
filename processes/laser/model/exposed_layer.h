#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/layer.h"
#include "processes/laser/model/exposure_options.h"

namespace slicefarm {

/// Lines of one object, region and kind in the order of scanning, around the object's own origin.
/// Flat, for millions of them.
struct ExposureGroup {
  int32_t object = 0;
  int32_t settings = 0;  ///< index into the job's tables of region settings
  ExposureKind kind = ExposureKind::kHatch;
  /// Skywriting: the scanner comes and goes on this length of each line's direction, beam off.
  Coord run_nm = 0;
  std::vector<Point> points;  ///< of all lines, one after the other
  /// Number of points of each line, or empty: all are hatch lines of two points. A closed line
  /// repeats its first point.
  std::vector<int32_t> line_sizes;

  bool IsHatch() const { return line_sizes.empty(); }
  size_t LineCount() const { return IsHatch() ? points.size() / 2 : line_sizes.size(); }
  void AddLine(std::span<const Point> line) {
    points.insert(points.end(), line.begin(), line.end());
    line_sizes.push_back(static_cast<int32_t>(line.size()));
  }
  /// Calls visit(span of points) for each line.
  template <typename Visit>
  void ForEachLine(Visit visit) const {
    size_t first = 0;
    for (size_t line = 0, lines = LineCount(); line < lines; ++line) {
      const size_t size = IsHatch() ? 2 : static_cast<size_t>(line_sizes[line]);
      visit(std::span<const Point>(points).subspan(first, size));
      first += size;
    }
  }
  friend bool operator==(const ExposureGroup&, const ExposureGroup&) = default;
};

/// A copy of an object on the plate: all groups of the object, shifted.
struct ExposureVisit {
  int32_t object = 0;
  int32_t copy = 0;  ///< index into the job's copies
  Point shift;       ///< from the object's origin

  friend bool operator==(const ExposureVisit&, const ExposureVisit&) = default;
};

/// Where the cuts of a layer's decomposition into convex pieces came out; of rings only.
struct CutCounts {
  int64_t pieces = 0;
  int64_t reflex = 0;        ///< corners over 180 degrees
  int64_t extra_points = 0;  ///< ends of cuts that are no corners
  int64_t sharp_cuts = 0;    ///< cuts with an angle below 30 degrees, where no better one was
  int64_t replaced = 0;      ///< outlines cut by Bian's method, as the one asked for cannot

  void Add(const CutCounts& other) {
    pieces += other.pieces;
    reflex += other.reflex;
    extra_points += other.extra_points;
    sharp_cuts += other.sharp_cuts;
    replaced += other.replaced;
  }
  friend bool operator==(const CutCounts&, const CutCounts&) = default;
};

/// What a few lines across each layer meet: a sample of what is melted, and how much.
struct MeltedSample {
  double length_mm = 0;    ///< of the lines, inside of the outlines
  double melted_mm = 0;    ///< of it, no farther than half a spot from a vector
  double energy_j_mm = 0;  ///< energy by area, added up along the lines
  int64_t pieces = 0;      ///< of about a millimetre
  double least_j_mm2 = 0;  ///< of a piece
  double most_j_mm2 = 0;

  /// Of 1; 1 of nothing.
  double Melted() const { return length_mm > 0 ? melted_mm / length_mm : 1; }
  double MeanJmm2() const { return length_mm > 0 ? energy_j_mm / length_mm : 0; }
  void AddPiece(double j_mm2) {
    least_j_mm2 = pieces == 0 ? j_mm2 : std::min(least_j_mm2, j_mm2);
    most_j_mm2 = std::max(most_j_mm2, j_mm2);
    ++pieces;
  }
  void Add(const MeltedSample& other) {
    length_mm += other.length_mm;
    melted_mm += other.melted_mm;
    energy_j_mm += other.energy_j_mm;
    if (other.pieces > 0)
      least_j_mm2 = pieces == 0 ? other.least_j_mm2 : std::min(least_j_mm2, other.least_j_mm2);
    most_j_mm2 = std::max(most_j_mm2, other.most_j_mm2);
    pieces += other.pieces;
  }
  friend bool operator==(const MeltedSample&, const MeltedSample&) = default;
};

struct ExposedLayer {
  LayerFrame frame;
  std::vector<ExposureGroup> groups;  ///< by object; of each in the order of scanning
  std::vector<ExposureVisit> visits;  ///< in the order of scanning
  double area_mm2 = 0;                ///< of the outlines of all visits
  CutCounts cuts;
  MeltedSample melted;  ///< of one copy of each object

  friend bool operator==(const ExposedLayer&, const ExposedLayer&) = default;
};

/// What one kind of vector takes.
struct KindExposure {
  int64_t vectors = 0;  ///< edges
  int64_t lines = 0;    ///< times that the beam goes on, and off again
  double length_mm = 0;
  double time_s = 0;  ///< delays at the ends and corners of lines included
  double energy_j = 0;

  void Add(const KindExposure& other) {
    vectors += other.vectors;
    lines += other.lines;
    length_mm += other.length_mm;
    time_s += other.time_s;
    energy_j += other.energy_j;
  }
  friend bool operator==(const KindExposure&, const KindExposure&) = default;
};

/// Sums over layers.
struct ExposureReport {
  std::array<KindExposure, kExposureKindCount> kinds;  ///< by ExposureKind
  int64_t jumps = 0;
  double jump_mm = 0;      ///< beam off, skywriting included
  double jump_time_s = 0;  ///< delays after jumps included
  double area_mm2 = 0;     ///< of outlines
  double volume_mm3 = 0;   ///< of outlines by their layers' heights
  CutCounts cuts;
  MeltedSample melted;
  Box bounds;  ///< of what is exposed, on the plate

  KindExposure Total() const {
    KindExposure total;
    for (const KindExposure& kind : kinds) total.Add(kind);
    return total;
  }
  double TimeS() const { return Total().time_s + jump_time_s; }
  /// Of the volume; 0 of nothing.
  double EnergyDensityJmm3() const { return volume_mm3 > 0 ? Total().energy_j / volume_mm3 : 0; }
  void Add(const ExposureReport& other) {
    for (size_t kind = 0; kind < kinds.size(); ++kind) kinds[kind].Add(other.kinds[kind]);
    jumps += other.jumps;
    jump_mm += other.jump_mm;
    jump_time_s += other.jump_time_s;
    area_mm2 += other.area_mm2;
    volume_mm3 += other.volume_mm3;
    cuts.Add(other.cuts);
    melted.Add(other.melted);
    bounds.Add(other.bounds);
  }
  friend bool operator==(const ExposureReport&, const ExposureReport&) = default;
};

}  // namespace slicefarm
