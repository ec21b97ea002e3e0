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

/// Lines of one object, region and kind in the order of scanning, relative to the object's own
/// origin. The lines are stored in flat arrays because a layer can have millions of them.
struct ExposureGroup {
  int32_t object = 0;
  int32_t settings = 0;  ///< index into the job's tables of region settings
  ExposureKind kind = ExposureKind::kHatch;
  /// Skywriting: length by which the scanner extends each line at both ends with the beam off.
  Coord run_nm = 0;
  std::vector<Point> points;  ///< points of all lines, one line after the other
  /// Number of points of each line. Empty: all lines are hatch lines of two points. A closed line
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

/// Placement of one copy of an object on the plate: all groups of the object are shifted.
struct ExposureVisit {
  int32_t object = 0;
  int32_t copy = 0;  ///< index into the job's copies
  Point shift;       ///< displacement from the object's origin

  friend bool operator==(const ExposureVisit&, const ExposureVisit&) = default;
};

/// Statistics of the decomposition of a layer's outlines into convex pieces. Only the ring
/// strategies use such a decomposition.
struct CutCounts {
  int64_t pieces = 0;
  int64_t reflex = 0;        ///< number of corners over 180 degrees
  int64_t extra_points = 0;  ///< number of ends of cuts that are not corners of the outline
  int64_t sharp_cuts = 0;  ///< number of cuts at an angle below 30 degrees for lack of a better cut
  /// Number of outlines cut by Bian's method because the requested method cannot cut them.
  int64_t replaced = 0;

  void Add(const CutCounts& other) {
    pieces += other.pieces;
    reflex += other.reflex;
    extra_points += other.extra_points;
    sharp_cuts += other.sharp_cuts;
    replaced += other.replaced;
  }
  friend bool operator==(const CutCounts&, const CutCounts&) = default;
};

/// Sample of the melted area and its energy, taken along a few lines across each layer.
struct MeltedSample {
  double length_mm = 0;    ///< length of the sample lines inside the outlines
  double melted_mm = 0;    ///< part of `length_mm` within half a spot of a vector
  double energy_j_mm = 0;  ///< energy per area, integrated along the sample lines
  int64_t pieces = 0;      ///< number of sampled pieces of about 1 mm
  double least_j_mm2 = 0;  ///< lowest energy per area of a sampled piece
  double most_j_mm2 = 0;

  /// Returns the melted share of the sample lines, in [0, 1]. Returns 1 for an empty sample.
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

/// Vectors of one layer, as the exposure stage makes them.
struct ExposedLayer {
  LayerFrame frame;
  /// Groups sorted by object. The groups of one object are in the order of scanning.
  std::vector<ExposureGroup> groups;
  std::vector<ExposureVisit> visits;  ///< placements in the order of scanning
  double area_mm2 = 0;                ///< area of the outlines of all placements
  CutCounts cuts;
  MeltedSample melted;  ///< sample of one copy of each object

  friend bool operator==(const ExposedLayer&, const ExposedLayer&) = default;
};

/// Totals of one kind of vector.
struct KindExposure {
  int64_t vectors = 0;  ///< number of straight segments of lines
  int64_t lines = 0;    ///< number of times that the beam is switched on and off
  double length_mm = 0;
  double time_s = 0;  ///< time, including the delays at the ends and corners of lines
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

/// Totals over layers.
struct ExposureReport {
  std::array<KindExposure, kExposureKindCount> kinds;  ///< totals per ExposureKind
  int64_t jumps = 0;
  double jump_mm = 0;      ///< path length with the beam off, including skywriting
  double jump_time_s = 0;  ///< time of jumps, including the delays after them
  double area_mm2 = 0;     ///< area of the outlines
  double volume_mm3 = 0;   ///< sum of each layer's outline area times its height
  CutCounts cuts;
  MeltedSample melted;
  Box bounds;  ///< bounding box of all exposed vectors on the plate

  KindExposure Total() const {
    KindExposure total;
    for (const KindExposure& kind : kinds) total.Add(kind);
    return total;
  }
  double TimeS() const { return Total().time_s + jump_time_s; }
  /// Returns the energy per volume, in J/mm3. Returns 0 for an empty volume.
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
