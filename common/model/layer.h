#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/model/path.h"

namespace slicefarm {

/// One message type per hop:
///   SlicedLayer -> beading -> WalledLayer -> infill -> FilledLayer -> ordering -> OrderedLayer ->
///   motion -> LayerProgram

/// Where a layer lies, and what all stages after the one that finds it out pass on.
struct LayerFrame {
  int32_t index = 0;
  Coord print_z_nm = 0;  ///< height of the nozzle: the layer's top
  Coord height_nm = 0;
  int32_t plain_islands = 0;  ///< that got walls of constant width, as others could not be made

  friend bool operator==(const LayerFrame&, const LayerFrame&) = default;
};

/// Layers [first, last).
struct LayerRange {
  int32_t first = 0;
  int32_t last = 0;

  int32_t size() const { return last - first; }
  bool empty() const { return first == last; }
  bool Contains(int32_t index) const { return first <= index && index < last; }
  /// This range with `by` more layers on either side, cut to [0, layer_count).
  LayerRange Grown(int32_t by, int32_t layer_count) const;
  friend bool operator==(const LayerRange&, const LayerRange&) = default;
};

/// The section of one object (one copy) in one layer.
struct ObjectSection {
  int32_t object = 0;
  MultiPolygon outlines;

  friend bool operator==(const ObjectSection&, const ObjectSection&) = default;
};

struct SlicedLayer {
  LayerFrame frame;
  std::vector<ObjectSection> objects;  ///< by ascending object, those without outlines left out

  friend bool operator==(const SlicedLayer&, const SlicedLayer&) = default;
};

/// One island with its walls, and what is left for the infill: the region that the infill's beads
/// may cover, edge to edge, less any overlap with the walls (which is the infill's option).
struct WalledIsland {
  int32_t object = 0;
  std::vector<Path> walls;  ///< walls and gap fill, in no particular order
  MultiPolygon fill_area;

  friend bool operator==(const WalledIsland&, const WalledIsland&) = default;
};

struct WalledLayer {
  LayerFrame frame;
  std::vector<WalledIsland> islands;

  friend bool operator==(const WalledLayer&, const WalledLayer&) = default;
};

/// Lines that fill one connected region of an island.
struct FillGroup {
  bool keep_order = false;  ///< monotonic: the paths are printed in this order and direction
  std::vector<Path> paths;

  friend bool operator==(const FillGroup&, const FillGroup&) = default;
};

struct FilledIsland {
  int32_t object = 0;
  std::vector<Path> walls;
  std::vector<FillGroup> fills;

  friend bool operator==(const FilledIsland&, const FilledIsland&) = default;
};

struct FilledLayer {
  LayerFrame frame;
  std::vector<FilledIsland> islands;

  friend bool operator==(const FilledLayer&, const FilledLayer&) = default;
};

/// What is decided for a layer from the outlines of the whole job, before the fan-out, so that
/// layers are independent afterwards.
struct LayerPlan {
  Point entry;               ///< start the layer near here
  std::vector<Point> seams;  ///< start each loop near one of these; empty: near the nozzle

  friend bool operator==(const LayerPlan&, const LayerPlan&) = default;
};

/// Paths in the order and direction of printing. A closed path starts (and ends) at its first
/// point.
struct OrderedLayer {
  LayerFrame frame;
  std::vector<Path> paths;

  friend bool operator==(const OrderedLayer&, const OrderedLayer&) = default;
};

/// What one feature takes.
struct FeatureUse {
  double time_s = 0;
  double length_mm = 0;
  double filament_mm = 0;
  double volume_mm3 = 0;

  void Add(const FeatureUse& other);
  friend bool operator==(const FeatureUse&, const FeatureUse&) = default;
};

struct ProgramStats {
  std::array<FeatureUse, kFeatureCount> features;  ///< by Feature
  double travel_time_s = 0;                        ///< retractions included
  double travel_mm = 0;
  int64_t travels = 0;
  int64_t retractions = 0;
  Box bounds;  ///< of what is extruded

  double TimeS() const;
  double FilamentMm() const;
  double VolumeMm3() const;
  double ExtrudedMm() const;
  void Add(const ProgramStats& other);
  friend bool operator==(const ProgramStats&, const ProgramStats&) = default;
};

/// The G-code of one layer. It starts and ends in the canonical state: filament retracted, relative
/// extrusion, absolute coordinates; so layers are joined by concatenation.
struct LayerProgram {
  LayerFrame frame;
  std::string gcode;
  Point entry;  ///< of the first path; the program's first move goes there from anywhere
  Point exit;
  ProgramStats stats;

  friend bool operator==(const LayerProgram&, const LayerProgram&) = default;
};

/// What stands around the layers: prologue, then for each layer its prefix and its program, then
/// epilogue.
struct ProgramFrame {
  std::string prologue;
  std::vector<std::string> layer_prefixes;  ///< one a layer (progress), most often empty
  std::string epilogue;
  double time_s = 0;     ///< the whole print: layers and the travel between them
  double travel_mm = 0;  ///< layers' and between them

  friend bool operator==(const ProgramFrame&, const ProgramFrame&) = default;
};

}  // namespace slicefarm
