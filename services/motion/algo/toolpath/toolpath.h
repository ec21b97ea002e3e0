#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/layers/layer.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// Value of Move::rest for a bead that is completely on the layer below; 0 is a bead in the air.
inline constexpr uint8_t kFullRest = 100;

/// Returns a length in the unit of moves: whole micrometres, with halves rounded away from zero.
/// REQUIRES: below 2 km.
inline int32_t ToUm(Coord nm) {
  return static_cast<int32_t>((nm >= 0 ? nm + 500 : nm - 500) / 1000);
}

/// Returns a length in nm, from the unit of moves.
inline Coord FromUm(int32_t um) { return Coord{um} * 1'000; }

/// Surface below a layer of an object.
enum class Ground : uint8_t {
  kBed,
  kRaft,
  kLayers,  ///< the object's own layers
};

/// Kind of a move.
enum class MoveKind : uint8_t {
  kPrint,
  kTravel,
  kRetract,
  kWipe,     ///< move along the printed bead, while the filament is retracted
  kRestart,  ///< move of the filament back to the nozzle
  kLift,     ///< move in z only
};

/// Returns true for moves along x and y.
inline bool MovesInPlane(MoveKind kind) {
  return kind == MoveKind::kPrint || kind == MoveKind::kTravel || kind == MoveKind::kWipe;
}

/// Move with the rounded values of the G-code, so that the planned times agree with the text.
struct Move {
  // End of the move.
  int32_t x_um = 0;
  int32_t y_um = 0;
  int32_t z_um = 0;
  int32_t filament = 0;          ///< extruded length in 1e-5 mm, relative
  int32_t feed_rate = 0;         ///< in mm/min
  int32_t width_um = 0;          ///< width of a bead
  int32_t height_um = 0;         ///< height of a bead
  float acceleration_mm_s2 = 0;  ///< acceleration; 0: the acceleration that earlier beads set
  float jerk_mm_s = 0;           ///< jerk in x and y; 0: the jerk that earlier beads set
  MoveKind kind = MoveKind::kTravel;
  Feature feature = Feature::kPerimeter;  ///< feature of the bead; only for kPrint
  /// share of the bead's width that the layer below supports, in percent; 0: in the air
  uint8_t rest = kFullRest;
  bool of_surface = false;  ///< true for a bead of the two outermost walls
  bool on_arc = false;      ///< true for a bead that an arc may replace
  /// True for a kRetract or kRestart that is written only if the filament is not yet in this state
  /// at the end of the layer below.
  bool if_needed = false;

  friend bool operator==(const Move&, const Move&) = default;
};

/// Beads printed as one arc: moves [first, last) of a toolpath. The arc begins at the end of the
/// move before `first`.
struct MoveArc {
  size_t first = 0;
  size_t last = 0;
  PointUm centre;
  bool clockwise = false;

  friend bool operator==(const MoveArc&, const MoveArc&) = default;
};

/// Moves of a layer or of a block. They begin at any x and y, with or without a retraction, at the
/// height `start_z_um`.
struct Toolpath {
  static constexpr size_t kNone = std::numeric_limits<size_t>::max();

  std::vector<Move> moves;
  std::vector<MoveArc> arcs;  ///< arcs in the order of the moves
  /// Index of the travel to the entry, or kNone. Its length is not known, because it depends on the
  /// layer before.
  size_t approach = kNone;
  int32_t start_z_um = 0;  ///< height of the nozzle before the moves: the top of the layer below
};

/// Offset in um that is added to the positions of moves.
struct ShiftUm {
  int32_t x = 0;
  int32_t y = 0;
};

/// Part of a program: moves [first, last) of a toolpath, shifted. A program is a list of spans.
struct MoveSpan {
  const Toolpath* path = nullptr;
  size_t first = 0;
  size_t last = 0;
  ShiftUm shift;
  int32_t copy = kNoCopy;         ///< copy to which the moves belong: see CopyUse
  int32_t travel_copy = kNoCopy;  ///< copy to which the moves up to Toolpath::approach belong

  /// Returns the first move that belongs to `copy`; the moves before it belong to `travel_copy`.
  size_t FirstOwn() const {
    return path->approach == Toolpath::kNone ? first : std::clamp(path->approach + 1, first, last);
  }
};

}  // namespace slicefarm::motion
