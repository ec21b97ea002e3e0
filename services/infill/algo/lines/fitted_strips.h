#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/geometry/vector.h"
#include "services/infill/algo/lines/scan_lines.h"

namespace slicefarm::infill {

/// A place on the middle of a bead, and how wide a strip the bead fills there.
struct StripPoint {
  Point at;
  double strip_nm = 0;

  friend bool operator==(const StripPoint&, const StripPoint&) = default;
};

/// The point at a share of the way from one to the other.
StripPoint Between(const StripPoint& a, const StripPoint& b, double share);

/// The strips of a region that solid lines fill: half a pitch to each side of a line. But where the
/// region's edge runs at a flat angle to the lines, the line beside the edge fills the room up to
/// it, less what a link takes that runs along the edge there. So lines leave no wedges between
/// their ends, and lie neither over walls nor over each other.
class FittedStrips {
 public:
  struct Options {
    std::vector<bool> linked;  ///< by crossing: a link runs from it to the next one on its ring
    double link_nm = 0;        ///< width of the links' strips
    double reach_nm = 0;       ///< what lies outside of the region of `lines` and is filled too
  };

  /// All strips are as wide as the pitch.
  explicit FittedStrips(const ScanLines& lines) : lines_(lines) {}

  /// `lines` must outlive this. Cost: O(n + k log k), n points of the region, k pieces.
  FittedStrips(const ScanLines& lines, const Options& options);

  /// The strip of the piece that begins at `place` (ScanLines::order), to its other end: two points
  /// or more.
  std::vector<StripPoint> From(int32_t place) const;

 private:
  /// How much farther than half a pitch a strip goes at a place along it.
  struct Knot {
    double u = 0;
    double more_nm = 0;
  };
  /// What a stretch of the edge leaves on one side of a piece; nothing more where there is none.
  struct Room {
    int32_t side = 0;  ///< twice the piece, and one above it
    std::vector<Knot> knots;
  };
  /// A stretch of the edge that is flat from one of its points to another, and the piece beside it.
  struct FlatStretch {
    std::vector<Vector2> way;  ///< u rises
    size_t first = 0, last = 0;
    int32_t line = 0, piece = 0;
    bool region_above = false;
    double reach_nm = 0;  ///< across the lines
  };

  std::optional<FlatStretch> FlatFrom(int32_t from, double reach_nm) const;
  void AddStretch(const FlatStretch& flat, int32_t from, double link_nm);
  double RoomAt(const FlatStretch& flat, size_t i) const;
  std::vector<Vector2> WayOf(int32_t from) const;
  int32_t LineBelow(int32_t from, const std::vector<Vector2>& way) const;
  int32_t PieceBeside(int32_t line, double from_u, double to_u) const;
  std::vector<Knot> Joined(std::vector<Knot> edge, bool own_start, bool own_end) const;
  std::vector<Knot> KnotsOf(int32_t side) const;
  static double MoreAt(const std::vector<Knot>& knots, double u);

  const ScanLines& lines_;
  std::vector<Room> rooms_;  ///< by side, then along it
};

}  // namespace slicefarm::infill
