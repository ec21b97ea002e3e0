#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/fill_stats.h"
#include "common/model/layers/surface_facet.h"
#include "common/model/path.h"
#include "common/model/print_times.h"
#include "common/model/region.h"
#include "common/model/scene/part_role.h"
#include "common/model/spiral.h"
#include "common/model/stack.h"

namespace slicefarm {

// Each pipeline step has its own message type:
//   SlicedLayer -> beading -> WalledLayer -> infill -> FilledLayer -> ordering -> OrderedLayer ->
//   motion -> LayerProgram

/// Index, position and height of a layer.
struct LayerFrame {
  int32_t index = 0;
  Coord print_z_nm = 0;  ///< nozzle height during the layer, equal to the layer's top
  Coord height_nm = 0;   ///< height above the top of the layer below

  friend bool operator==(const LayerFrame&, const LayerFrame&) = default;
};

/// Range of layers [first, last).
struct LayerRange {
  int32_t first = 0;
  int32_t last = 0;

  int32_t size() const { return last - first; }
  bool empty() const { return first == last; }
  bool Contains(int32_t index) const { return first <= index && index < last; }
  /// Returns this range with `by` more layers on either side, limited to [0, layer_count).
  LayerRange Grown(int32_t by, int32_t layer_count) const;
  friend bool operator==(const LayerRange&, const LayerRange&) = default;
};

/// Area in which a part enforces or blocks seams or supports. Only planning uses it.
struct Mark {
  PartRole role = PartRole::kSeamEnforcer;
  MultiPolygon outlines;

  friend bool operator==(const Mark&, const Mark&) = default;
};

/// Section of one stack in one of its layers, relative to the object's own origin. Copies have no
/// sections of their own: ordering places them on the plate.
struct ObjectSection {
  Stack stack;
  int32_t layer = 0;            ///< number of the layer within the stack; 0 is the lowest
  int32_t layer_count = 1;      ///< number of layers of the stack
  Coord height_nm = 0;          ///< height of this layer of the stack
  std::vector<Region> regions;  ///< disjoint regions
  /// Union of the outlines of all regions. Empty if there are fewer than two regions. See
  /// OutlineOf.
  MultiPolygon whole;
  Coord z_nm = 0;           ///< height of the layer's top above the stack's own bottom
  std::vector<Mark> marks;  ///< marks for planning only; at most one per role
  /// `spiral_vase`: true if the section has only one wall along its outline.
  bool hollow = false;
  /// `zaa_enabled`: facets of the object's upper side within the layer's height; else empty
  std::vector<SurfaceFacet> surface = {};

  friend bool operator==(const ObjectSection&, const ObjectSection&) = default;
};

/// Returns the area that the section covers. Rings are numbered through all islands; in each island
/// the outer ring precedes the holes.
const MultiPolygon& OutlineOf(const ObjectSection& section);

/// Returns the area of a section with a mark of the role; an empty area if there is no such mark.
const MultiPolygon& MarkedIn(const ObjectSection& section, PartRole role);

/// Sections of all stacks in one layer. A stack has a section in each of its own layers, even if
/// the section is empty.
struct SlicedLayer {
  LayerFrame frame;
  std::vector<ObjectSection> sections;  ///< sections, sorted by stack id

  friend bool operator==(const SlicedLayer&, const SlicedLayer&) = default;
};

/// Returns true if only supports are printed in the layer. Such a layer has a height between two
/// layers of the parts.
bool OnlySupports(const SlicedLayer& layer);

/// Area for the infill of one region. The beads of the infill may extend up to the area's boundary.
/// The overlap with the walls is not included, because it is an option of the infill.
struct FillArea {
  Role role = Role::kPart;
  int32_t settings = 0;
  int32_t tool = 0;
  MultiPolygon area;

  friend bool operator==(const FillArea&, const FillArea&) = default;
};

/// Island with its walls.
struct WalledIsland {
  std::vector<Path> walls;  ///< walls and gap fill, in no particular order
  std::vector<FillArea> fill_areas;
  PolygonWithHoles outline = {};  ///< outline from which the walls were made; empty: unknown

  friend bool operator==(const WalledIsland&, const WalledIsland&) = default;
};

/// Section of a stack with the walls of its islands.
struct WalledSection {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<WalledIsland> islands;

  friend bool operator==(const WalledSection&, const WalledSection&) = default;
};

/// Layer with walls, as beading makes it.
struct WalledLayer {
  LayerFrame frame;
  std::vector<WalledSection> sections;
  /// number of islands with walls of constant width, because kArachne failed
  int32_t plain_islands = 0;

  friend bool operator==(const WalledLayer&, const WalledLayer&) = default;
};

/// Lines that fill one connected area of an island.
struct FillGroup {
  /// True for monotonic infill: the paths are printed in this order and direction.
  bool keep_order = false;
  std::vector<Path> paths;

  friend bool operator==(const FillGroup&, const FillGroup&) = default;
};

/// Island with its walls and infill.
struct FilledIsland {
  std::vector<Path> walls;
  std::vector<FillGroup> fills;
  PolygonWithHoles outline = {};  ///< outline of the WalledIsland

  friend bool operator==(const FilledIsland&, const FilledIsland&) = default;
};

/// Section of a stack with the walls and infill of its islands.
struct FilledSection {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<FilledIsland> islands;
  std::vector<FillStats> uses = {};  ///< totals of the infill of `islands`: see AddUse

  friend bool operator==(const FilledSection&, const FilledSection&) = default;
};

/// Layer with walls and infill, as infill makes it.
struct FilledLayer {
  LayerFrame frame;
  std::vector<FilledSection> sections;

  friend bool operator==(const FilledLayer&, const FilledLayer&) = default;
};

/// Move without extrusion from the end of one path to the start of the next.
struct Travel {
  /// true if oozing during the travel is not visible, so that no retraction is needed
  bool hidden = false;
  std::vector<Point> corners;  ///< intermediate points of the travel; empty: straight line
  /// True if the travel crosses an outer wall. Then it needs a retraction even if it is short.
  bool over_wall = false;

  friend bool operator==(const Travel&, const Travel&) = default;
};

/// Travel from the last path of a block to the point `to`.
struct ExitTravel {
  Point to;
  Travel travel;

  friend bool operator==(const ExitTravel&, const ExitTravel&) = default;
};

/// Paths of one stack in the order and direction of printing, relative to the object's own origin.
/// A closed path starts and ends at its first point. INVARIANT: `paths` is not empty.
struct PathBlock {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<Path> paths;
  /// Travel to each path, indexed like `paths`. Empty: all travels are straight and visible. The
  /// travel to the first path is used only if the block is the first of a layer with
  /// OrderedLayer::begins_ready.
  std::vector<Travel> travels = {};
  /// travel to SectionPlan::exit, used if the block is the last of a layer with
  /// OrderedLayer::ends_ready
  std::optional<ExitTravel> exit_travel = {};
  /// Area that the stack's layer below covers. Only set for turns of a spiral, or if motion needs
  /// the area (LooksBelow); otherwise empty.
  MultiPolygon below = {};
  MultiPolygon above_supports = {};  ///< SectionPlan::above_supports, set if motion needs `below`
  MultiPolygon curled = {};          ///< SectionPlan::curled, set if motion slows walls above it
  /// SectionPlan::spiral, the turn that the only path follows
  std::optional<SpiralTurn> spiral = {};
  std::vector<SurfaceFacet> surface = {};  ///< ObjectSection::surface, which the paths follow

  friend bool operator==(const PathBlock&, const PathBlock&) = default;
};

/// Placement of one copy of a block on the plate.
struct BlockVisit {
  int32_t block = 0;       ///< index into OrderedLayer::blocks
  int32_t copy = kNoCopy;  ///< index into the job's copies; kNoCopy: the block is the plate's
  int32_t pass = 0;        ///< pass of the copy
  Point shift;             ///< displacement from the object's origin to the copy's position
  /// Intermediate points of the travel from the previous visit, on the plate. Empty: straight line.
  /// They are ignored for the first visit of a pass.
  std::vector<Point> corners = {};

  friend bool operator==(const BlockVisit&, const BlockVisit&) = default;
};

/// Layer with its paths in the order of printing, as ordering makes it.
struct OrderedLayer {
  LayerFrame frame;
  std::vector<PathBlock> blocks;
  std::vector<BlockVisit> visits;  ///< visits in the order of printing
  /// True: the layer begins with the filament in the state in which the layer below ends, ready or
  /// retracted. False: it begins with the filament retracted. `ends_ready` says the same about the
  /// layer above. If one of them is true, each block of the layer has one visit. The only exception
  /// is a spiral turn that is the layer's only block: it has one visit per pass.
  bool begins_ready = false;
  bool ends_ready = false;

  friend bool operator==(const OrderedLayer&, const OrderedLayer&) = default;
};

/// Totals of one feature.
struct FeatureUse {
  double time_s = 0;
  double length_mm = 0;
  double filament_mm = 0;
  double volume_mm3 = 0;

  void Add(const FeatureUse& other);
  friend bool operator==(const FeatureUse&, const FeatureUse&) = default;
};

/// Totals of one copy in one layer: beads, travels within the copy, retractions and wipes.
struct CopyUse {
  int32_t copy = 0;  ///< index of the copy in the job
  FeatureUse use;    ///< totals; the time includes travels

  friend bool operator==(const CopyUse&, const CopyUse&) = default;
};

/// Totals of a program: time, length, filament and volume.
struct ProgramStats {
  std::array<FeatureUse, kFeatureCount> features;  ///< totals per Feature
  double travel_time_s = 0;                        ///< time of travels, including retractions
  double retract_time_s = 0;  ///< part of `travel_time_s` that moves only the filament
  double travel_mm = 0;
  int64_t travels = 0;
  int64_t retractions = 0;
  Box bounds;  ///< bounding box of the extruded beads

  double TimeS() const;
  double FilamentMm() const;
  double VolumeMm3() const;
  double ExtrudedMm() const;
  void Add(const ProgramStats& other);
  friend bool operator==(const ProgramStats&, const ProgramStats&) = default;
};

/// Move at the start or end of a layer's program, rounded like its G-code. x, y and z are the
/// position at the move's end.
struct EdgeMove {
  int32_t x_um = 0;
  int32_t y_um = 0;
  int32_t z_um = 0;
  int32_t filament = 0;           ///< length of filament fed by this move, in 1e-5 mm
  int32_t feed_rate = 0;          ///< feed rate in mm/min
  double acceleration_mm_s2 = 0;  ///< acceleration; 0: the machine's current value
  double jerk_mm_s = 0;           ///< jerk in x and y; 0: the machine's current value
  /// Feature of a bead, which is a move in the plane that extrudes filament.
  Feature feature = Feature::kPerimeter;
  int32_t copy = kNoCopy;  ///< copy to which the move belongs: see CopyUse

  friend bool operator==(const EdgeMove&, const EdgeMove&) = default;
};

/// Moves at the start (`head`) and end (`tail`) of a layer. Their duration also depends on the
/// moves of the neighbouring layers. The first entry of each list is only the start position of the
/// first move. A list is empty if nothing moves.
struct LayerEdges {
  /// Moves at the start of the layer. x and y are unknown before the move `approach`.
  std::vector<EdgeMove> head;
  int32_t approach = 0;  ///< index in `head` of the move to LayerProgram::entry
  std::vector<EdgeMove> tail;
  double acceleration_mm_s2 = 0;  ///< acceleration setting of the machine at the end of the layer

  friend bool operator==(const LayerEdges&, const LayerEdges&) = default;
};

/// Number of custom G-code texts per layer: before_layer_gcode and layer_gcode.
inline constexpr int kCodesOfALayer = 2;

/// State of the machine that a command sets and that remains until a command changes it.
enum class MachineMode : uint8_t {
  kFan,
  kAcceleration,        ///< acceleration of all moves, or of printing moves only
  kTravelAcceleration,  ///< acceleration of travels, if the firmware has a separate one
  kPosition,            ///< position of the nozzle
  kFilament,            ///< state of the filament: retracted or ready to print
  kJerk,                ///< jerk in x and y, or square corner velocity
};
inline constexpr int kMachineModes = 6;

/// Values of MachineMode::kFilament.
inline constexpr std::string_view kReady = "ready", kRetracted = "retracted";

/// Values per MachineMode, as text. Empty: unknown.
using ModeValues = std::array<std::string, kMachineModes>;

/// Line of a layer's program that sets a mode to `value`. The line is unnecessary if the mode
/// already has this value.
struct ModeLine {
  int64_t at = 0;  ///< offset of the line's first byte in the G-code
  int64_t size = 0;
  MachineMode mode = MachineMode::kFan;
  std::string value;

  friend bool operator==(const ModeLine&, const ModeLine&) = default;
};

/// G-code of one layer of one pass. It starts and ends in the canonical state: relative extrusion,
/// absolute coordinates, filament retracted. If the OrderedLayer has `begins_ready`, the layer
/// instead starts in the filament state in which the layer below ends. Then one of `mode_lines`
/// retracts the filament or makes it ready. The layers' texts are concatenated without the mode
/// lines that have no effect.
struct LayerProgram {
  LayerFrame frame;
  int32_t pass = 0;  ///< number of the pass: see Copy::pass
  std::string gcode;
  /// Start of the first path in G-code coordinates. The program's first move leads to this point,
  /// from any position.
  Point entry;
  Point exit;
  /// Totals of the layer. The times assume a standstill before and after the layer, and exclude the
  /// approach to the entry.
  ProgramStats stats;
  LayerEdges edges;
  /// Offsets in `gcode`, ascending, at which before_layer_gcode and layer_gcode are inserted later
  /// (ProgramEnvelope::layer_code). Usually empty: `gcode` then already contains these texts. They
  /// are inserted later only if they depend on previous layers.
  std::vector<int64_t> code_at;
  std::vector<ModeLine> mode_lines = {};  ///< mode lines, sorted by offset
  /// Value of each mode at the end of the layer; an empty text if the layer does not change the
  /// mode. nullopt: custom G-code in the layer may have changed any mode.
  std::optional<ModeValues> modes_at_end = {};
  /// True if the layer ends with the filament retracted. Effects of custom G-code are not
  /// considered.
  bool ends_retracted = true;
  /// Convex hull of the beads on the plate, including their widths. Only set for a layer on the
  /// bed.
  Polygon footprint = {};
  /// Duration of the layer in the machine's silent mode, if MotionOptions has limits for it.
  double silent_time_s = 0;
  std::vector<CopyUse> copies = {};  ///< totals by copy, sorted by copy

  friend bool operator==(const LayerProgram&, const LayerProgram&) = default;
};

/// Texts around the layers of a program. The file consists of head, prologue, then a prefix and a
/// program for each layer, then epilogue and tail. Head and tail are comments, which other programs
/// read.
struct ProgramEnvelope {
  std::string prologue;
  std::vector<std::string> layer_prefixes;  ///< prefix of each layer (progress); usually empty
  std::string epilogue;
  PrintTimes times;      ///< times of the whole print
  double travel_mm = 0;  ///< length of the travels in layers and between them
  /// Texts that are inserted at LayerProgram::code_at: two per layer. Empty: no layer has code_at.
  std::vector<std::string> layer_code;
  std::string head;
  std::string tail;
  std::string file_name;  ///< name of the output file by `output_filename_format`, without a folder

  friend bool operator==(const ProgramEnvelope&, const ProgramEnvelope&) = default;
};

}  // namespace slicefarm
