#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "common/geometry/arc_fit.h"
#include "common/model/path.h"

namespace slicefarm::motion {

/// How much of a bead's width rests on the layer below, in steps: 0 is nothing, kFullRest all of
/// it.
inline constexpr uint8_t kFullRest = 100;

/// A length as moves have it: whole micrometres, half of one away from zero. REQUIRES: below 2 km.
inline int32_t ToUm(Coord nm) {
  return static_cast<int32_t>((nm >= 0 ? nm + 500 : nm - 500) / 1000);
}

inline Coord FromUm(int32_t um) { return Coord{um} * 1'000; }

/// What a layer of an object lies on.
enum class Ground : uint8_t {
  kBed,
  kRaft,
  kLayers,  ///< its own
};

enum class MoveKind : uint8_t {
  kPrint,
  kTravel,
  kRetract,
  kWipe,     ///< along what was printed, while the filament is pulled back
  kRestart,  ///< the filament comes back
  kLift,     ///< z alone
};

inline bool MovesInPlane(MoveKind kind) {
  return kind == MoveKind::kPrint || kind == MoveKind::kTravel || kind == MoveKind::kWipe;
}

/// A move as it will stand in the G-code: rounded to its digits already, so that plan and text
/// agree.
struct Move {
  // Where it ends.
  int32_t x_um = 0;
  int32_t y_um = 0;
  int32_t z_um = 0;
  int32_t filament = 0;   ///< in 1e-5 mm, relative
  int32_t feed_rate = 0;  ///< mm/min
  int32_t width_um = 0;   ///< of a bead
  int32_t height_um = 0;  ///< of a bead
  float acceleration_mm_s2 = 0;  ///< 0: what the machine is set to by the beads before
  MoveKind kind = MoveKind::kTravel;
  Feature feature = Feature::kPerimeter;  ///< of kPrint
  uint8_t rest = kFullRest;               ///< of a bead: how much of it has something below
  bool of_surface = false;                ///< of a bead: of the two outermost walls
  bool on_arc = false;                    ///< of a bead: an arc may stand for it
  bool if_needed = false;  ///< kRetract, kRestart: the layer below may have left the filament so

  friend bool operator==(const Move&, const Move&) = default;
};

/// Beads that are printed as one arc: moves [first, last) of a toolpath, from where the one before
/// them ends.
struct MoveArc {
  size_t first = 0;
  size_t last = 0;
  PlaceUm centre;
  bool clockwise = false;

  friend bool operator==(const MoveArc&, const MoveArc&) = default;
};

/// The moves of a layer. It starts anywhere, retracted or not, at the height of the layer before.
struct Toolpath {
  static constexpr size_t kNone = std::numeric_limits<size_t>::max();

  std::vector<Move> moves;
  std::vector<MoveArc> arcs;  ///< in their order
  size_t approach = kNone;  ///< the travel to the entry, whose length the layer does not know
  int32_t start_z_um = 0;   ///< of the layer before
};

/// What is added to the places of moves.
struct ShiftUm {
  int32_t x = 0;
  int32_t y = 0;
};

/// Moves [first, last) of a toolpath, in a place: a program is a list of these.
struct Stretch {
  const Toolpath* path = nullptr;
  size_t first = 0;
  size_t last = 0;
  ShiftUm shift;
};

}  // namespace slicefarm::motion
