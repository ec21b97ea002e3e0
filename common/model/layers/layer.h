#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/geometry/measure.h"
#include "common/geometry/polygon.h"
#include "common/model/layers/fill_use.h"
#include "common/model/path.h"
#include "common/model/print_times.h"
#include "common/model/region.h"
#include "common/model/scene/part_role.h"
#include "common/model/spiral.h"
#include "common/model/stack.h"

namespace slicefarm {

/// One message type per hop:
///   SlicedLayer -> beading -> WalledLayer -> infill -> FilledLayer -> ordering -> OrderedLayer ->
///   motion -> LayerProgram

/// Where a layer lies.
struct LayerFrame {
  int32_t index = 0;
  Coord print_z_nm = 0;  ///< height of the nozzle: the layer's top
  Coord height_nm = 0;   ///< from the top of the layer below

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

/// What a part of an object asks of planning where it lies: seams or supports, to be there or not.
struct Mark {
  PartRole role = PartRole::kSeamEnforcer;
  MultiPolygon outlines;

  friend bool operator==(const Mark&, const Mark&) = default;
};

/// The section of one stack in one of its layers, around the object's own origin. Copies are not
/// sections: ordering puts them in their places.
struct ObjectSection {
  Stack stack;
  int32_t layer = 0;        ///< of the stack's own layers: 0 is its lowest
  int32_t layer_count = 1;  ///< how many layers the stack has
  Coord height_nm = 0;      ///< of this stack's layer
  std::vector<Region> regions;  ///< disjoint
  /// The outlines of all regions together; empty where there is one region at most. See OutlineOf.
  MultiPolygon whole;
  Coord z_nm = 0;  ///< of the layer's top, above the stack's own bottom
  std::vector<Mark> marks;  ///< for planning alone; at most one of a role
  /// spiral_vase: it has nothing but one wall, along its outline.
  bool hollow = false;

  friend bool operator==(const ObjectSection&, const ObjectSection&) = default;
};

/// What the section covers. Rings are numbered through: by island, outer ring before holes.
const MultiPolygon& OutlineOf(const ObjectSection& section);

/// What is marked so in a section; empty: nothing.
const MultiPolygon& MarkedIn(const ObjectSection& section, PartRole role);

/// A stack has a section in each of its own layers, be it empty.
struct SlicedLayer {
  LayerFrame frame;
  std::vector<ObjectSection> sections;  ///< by ascending stack

  friend bool operator==(const SlicedLayer&, const SlicedLayer&) = default;
};

/// Whether nothing but supports is printed in a layer, between those of all parts.
bool OnlySupports(const SlicedLayer& layer);

/// What is left for the infill of one region: the area that the infill's beads may cover, edge to
/// edge, less any overlap with the walls (which is the infill's option).
struct FillArea {
  Role role = Role::kPart;
  int32_t settings = 0;
  int32_t tool = 0;
  MultiPolygon area;

  friend bool operator==(const FillArea&, const FillArea&) = default;
};

/// One island with its walls.
struct WalledIsland {
  std::vector<Path> walls;  ///< walls and gap fill, in no particular order
  std::vector<FillArea> fill_areas;
  PolygonWithHoles outline = {};  ///< what its walls were made of; not known if empty

  friend bool operator==(const WalledIsland&, const WalledIsland&) = default;
};

struct WalledSection {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<WalledIsland> islands;

  friend bool operator==(const WalledSection&, const WalledSection&) = default;
};

struct WalledLayer {
  LayerFrame frame;
  std::vector<WalledSection> sections;
  int32_t plain_islands = 0;  ///< islands that fell back to walls of constant width

  friend bool operator==(const WalledLayer&, const WalledLayer&) = default;
};

/// Lines that fill one connected region of an island.
struct FillGroup {
  bool keep_order = false;  ///< monotonic: the paths are printed in this order and direction
  std::vector<Path> paths;

  friend bool operator==(const FillGroup&, const FillGroup&) = default;
};

struct FilledIsland {
  std::vector<Path> walls;
  std::vector<FillGroup> fills;
  PolygonWithHoles outline = {};  ///< as WalledIsland's

  friend bool operator==(const FilledIsland&, const FilledIsland&) = default;
};

struct FilledSection {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<FilledIsland> islands;
  std::vector<FillUse> uses = {};  ///< what `islands` are filled with: see AddUse

  friend bool operator==(const FilledSection&, const FilledSection&) = default;
};

struct FilledLayer {
  LayerFrame frame;
  std::vector<FilledSection> sections;

  friend bool operator==(const FilledLayer&, const FilledLayer&) = default;
};

/// The way to a path from the end of the one before it.
struct Travel {
  bool hidden = false;         ///< what oozes out is not seen: the filament need not go back
  std::vector<Point> corners;  ///< on the way; none: straight on
  bool over_wall = false;      ///< crosses an outer wall: however short, the filament goes back

  friend bool operator==(const Travel&, const Travel&) = default;
};

/// The way on from the last path of a block.
struct Leave {
  Point to;
  Travel way;

  friend bool operator==(const Leave&, const Leave&) = default;
};

/// Paths of one stack in the order and direction of printing, around the object's own origin. A closed path starts (and ends) at its first point. INVARIANT: not empty.
struct PathBlock {
  Stack stack;
  int32_t layer = 0;
  Coord height_nm = 0;
  std::vector<Path> paths;
  /// To each path, or empty: all straight and in sight. The way to the first is looked at only
  /// where the block begins a layer that begins ready.
  std::vector<Travel> travels = {};
  std::optional<Leave> leave = {};  ///< where the block may end a layer that ends ready
  /// What the stack's layer below covers, where motion asks for it (LooksBelow), and below turns of
  /// a spiral; else empty.
  MultiPolygon below = {};
  MultiPolygon carried = {};  ///< as SectionPlan::carried, where motion asks for `below`
  std::optional<SpiralTurn> spiral = {};  ///< as SectionPlan's, of the only path

  friend bool operator==(const PathBlock&, const PathBlock&) = default;
};

/// A copy of a block on the plate.
struct BlockVisit {
  int32_t block = 0;  ///< index into OrderedLayer::blocks
  int32_t copy = -1;  ///< index into the job's copies; -1: of the plate
  int32_t pass = 0;   ///< of the copy
  Point shift;        ///< from the object's origin to the copy's place
  /// Of the way from the visit before, on the plate; none: straight on. Not looked at for the first
  /// visit of a pass.
  std::vector<Point> corners = {};

  friend bool operator==(const BlockVisit&, const BlockVisit&) = default;
};

struct OrderedLayer {
  LayerFrame frame;
  std::vector<PathBlock> blocks;
  std::vector<BlockVisit> visits;  ///< in the order of printing
  /// The layer meets the one below or above in the middle of a print: the filament may be ready or
  /// retracted there, as it suits the layer below. Else it is retracted. No block of such a layer has
  /// two visits, but for a turn of a spiral alone: one in each pass.
  bool begins_ready = false;
  bool ends_ready = false;

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
  double retract_time_s = 0;                       ///< of that, what moves the filament alone
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

/// A move at an end of a layer's program, rounded as its G-code is: where it ends, and how it goes.
struct EdgeMove {
  int32_t x_um = 0;
  int32_t y_um = 0;
  int32_t z_um = 0;
  int32_t filament = 0;           ///< in 1e-5 mm, relative
  int32_t feed_rate = 0;          ///< mm/min
  double acceleration_mm_s2 = 0;  ///< 0: what the machine is set to
  Feature feature = Feature::kPerimeter;  ///< of a bead: a move in the plane that pushes filament

  friend bool operator==(const EdgeMove&, const EdgeMove&) = default;
};

/// The moves of a layer whose times depend on what is printed before it and after it. Each list
/// begins with the place that its first move starts from; none if nothing moves.
struct LayerEdges {
  std::vector<EdgeMove> head;  ///< x and y are not known before the approach
  int32_t approach = 0;        ///< the move of `head` that goes to the layer's entry
  std::vector<EdgeMove> tail;
  double acceleration_mm_s2 = 0;  ///< what the machine is set to at the end

  friend bool operator==(const LayerEdges&, const LayerEdges&) = default;
};

/// before_layer_gcode and layer_gcode.
inline constexpr int kCodesOfALayer = 2;

/// What a program sets and the machine keeps until it is set anew.
enum class MachineMode : uint8_t {
  kFan,
  kAcceleration,        ///< of all moves, or of those that print
  kTravelAcceleration,  ///< where travels have one of their own
  kPlace,               ///< where the nozzle is
  kFilament,            ///< retracted, or ready to print
};
inline constexpr int kMachineModes = 5;

/// Values of MachineMode::kFilament.
inline constexpr std::string_view kReady = "ready", kRetracted = "retracted";

/// Values by MachineMode, as text; empty: not known.
using ModeValues = std::array<std::string, kMachineModes>;

/// A line of a layer's program that changes nothing where the mode has this value already.
struct ModeLine {
  int64_t at = 0;  ///< of its first byte in the G-code
  int64_t size = 0;
  MachineMode mode = MachineMode::kFan;
  std::string value;

  friend bool operator==(const ModeLine&, const ModeLine&) = default;
};

/// The G-code of one layer (of one pass). It starts and ends in the canonical state: relative
/// extrusion, absolute coordinates, filament retracted. Where OrderedLayer says that it meets another
/// layer, the filament is as that layer leaves it, and `mode_lines` has the line that retracts it or
/// makes it ready. Layers are joined by concatenation, without the lines that are not needed.
struct LayerProgram {
  LayerFrame frame;
  int32_t pass = 0;  ///< see Copy::pass
  std::string gcode;
  /// Where the first path begins, in the G-code's coordinates; the program's first move goes there
  /// from anywhere.
  Point entry;
  Point exit;
  ProgramStats stats;  ///< times: from rest to rest, without the approach to the entry
  LayerEdges edges;
  /// Places in `gcode`, upwards, where before_layer_gcode and layer_gcode go that depend on what the
  /// layers before them did (ProgramEnvelope::layer_code); most often none: they stand there.
  std::vector<int64_t> code_at;
  std::vector<ModeLine> mode_lines = {};  ///< upwards
  /// Modes at the end; an empty value: as before the layer. None: the settings' own G-code in the
  /// layer may have changed any of them.
  std::optional<ModeValues> modes_at_end = {};
  bool ends_retracted = true;  ///< whatever the settings' own G-code does
  /// Convex hull of the beads, edges included, on the plate; only of a layer that lies on the bed.
  Polygon footprint = {};
  double silent_time_s = 0;  ///< in the machine's silent mode, if MotionOptions has it

  friend bool operator==(const LayerProgram&, const LayerProgram&) = default;
};

/// What stands around the layers: head, prologue, then for each layer its prefix and its program,
/// then epilogue and tail. Head and tail are comments for those who read files.
struct ProgramEnvelope {
  std::string prologue;
  std::vector<std::string> layer_prefixes;  ///< one a layer (progress), most often empty
  std::string epilogue;
  PrintTimes times;      ///< of the whole print
  double travel_mm = 0;  ///< layers' and between them
  /// What goes to the places LayerProgram::code_at: two texts a layer, or none at all.
  std::vector<std::string> layer_code;
  std::string head;
  std::string tail;
  std::string file_name;  ///< what the settings call the file, without a folder

  friend bool operator==(const ProgramEnvelope&, const ProgramEnvelope&) = default;
};

}  // namespace slicefarm
