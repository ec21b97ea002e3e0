#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/model/layers/layer.h"
#include "common/model/options/region_motion.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/overhang.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/simplified_path.h"
#include "services/motion/algo/toolpath/surface_follower.h"
#include "services/motion/algo/toolpath/toolpath.h"
#include "services/motion/algo/toolpath/travel_ramp.h"
#include "services/motion/algo/toolpath/wipe.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Converts paths to moves, one path after the other: travels with retraction and lift, and beads
/// with their filament.
///
/// The builder first simplifies each path within `resolution_nm` (simplified_path.h). No other
/// stage simplifies paths.
///
/// The filament of a bead is its section (SectionMm2) times the extrusion multiplier. A path of
/// varying width is divided into segments of one width (divided_path.h). Rounding remainders are
/// added to the next move, so the sum over a layer is exact to 1e-5 mm. Segments that round to zero
/// length are left out, but their filament is kept.
///
/// Loops with a scarf (scarf.h) end beyond their start; the travel from there is short. The first
/// layer has no scarfs. A retraction wipes (wipe.h). After a scarf, which becomes thinner by
/// itself, and after a path that follows the surface, there is no wipe. Travels start at the end of
/// the wipe.
///
/// At the boundary to the layer below, the filament may be retracted or ready. The layer's first
/// retraction or restart is needed only in one of these two cases, and is marked (Move::if_needed).
class ToolpathBuilder {
 public:
  /// `options`, `below` and `above_supports` must outlive the builder. `below`: layer below, which
  /// slows walls down over air; null: walls are not slowed down, or the layer is not known.
  /// `above_supports`: areas directly above supports, where walls are not printed as bridges; null:
  /// none. `curled`: areas where the layer below has curled up, and walls are slower; null: none.
  /// `bead_height_nm`: bead height of the paths.
  ToolpathBuilder(const MotionOptions& options, const LayerFrame& frame, Coord bead_height_nm,
                  Ground ground = Ground::kLayers, const LayerBelow* below = nullptr,
                  const LayerBelow* above_supports = nullptr, const LayerBelow* curled = nullptr);

  /// Starts with a filament that the layer below has retracted by another length, in mm. Call
  /// before anything is added.
  void BeginRetracted(double length_mm);

  /// Starts with the filament in the state in which the layer below ends. Call before anything is
  /// added.
  void BeginAsLeft() {
    retracted_ = false;
    as_left_ = true;
  }

  /// Lets the paths follow the surface (Z contouring). `follower` must outlive the builder. Call
  /// before anything is added.
  void FollowSurface(SurfaceFollower* follower) { follower_ = follower; }

  /// Adds a path. `travel`: travel to this path; for the first path it is used only after
  /// BeginAsLeft. `contour_mm`: the path's element of ContourLengthsMm; if it is missing, the
  /// path's own length is used.
  void Add(const Path& path, const Travel& travel = {}, std::optional<double> contour_mm = {});

  /// Adds the only bead of a layer of a spiral: a loop along which the nozzle rises from the bottom
  /// of the layer to its top. If the turn is blended with the turn below, its points gradually move
  /// from the turn below to the loop (TurnOf). In the first turn of a spiral the flow grows from 0.
  /// The last turn is followed by a level turn with decreasing flow, so the total flow equals that
  /// of as many full loops. `below`: outline of the layer below. REQUIRES: `path` starts at
  /// `turn.start`.
  void AddTurn(const Path& path, const SpiralTurn& turn, const MultiPolygon& below);

  /// Returns the added moves, after a retraction. Call once.
  Toolpath Finish();

  /// Returns the added moves of a layer that the layer above continues without a break.
  /// `exit_travel`: travel to the layer above. The filament ends retracted if this travel requires
  /// it. Without a travel it ends ready to print. Call once.
  Toolpath FinishAt(const std::optional<ExitTravel>& exit_travel);

  bool retracted() const { return retracted_; }

  /// Returns the statistics of the added paths: lengths, volumes, travels, retractions and bounds;
  /// no times.
  const ProgramStats& stats() const { return stats_; }

 private:
  /// Values that the segments of one width have in common.
  struct Bead {
    Coord width_nm = 0;
    double filament_per_mm = 0;  ///< extruded length per mm of bead, in 1e-5 mm
    int32_t feed_rate = 0;
    double largest_flow_mm3_s = 0;
  };

  Bead BeadOf(Coord width_nm, double speed_mm_s) const;
  double FlowOf(Feature feature, const RegionMotion& region) const;
  void AddPath(const Path& path, const Travel& travel, std::optional<double> contour_mm,
               bool scarfed, bool reversed);
  Point InsideOf(const Path& path, bool reversed) const;
  bool OverhangsAtStart(const Path& path, const ScarfOptions& scarf) const;
  double WipeShiftOf(const Path& path) const;
  std::vector<RampPoint> RiseOf(std::span<const PointUm> points) const;
  void GlideTo(Point to, double speed_mm_s);
  void Approach(Point to, const Travel& travel);
  void GoTo(Point to, const Travel& travel);
  void Rise(std::span<const PointUm> points);
  void PrintSegments(const SimplifiedPath& simple, double speed_mm_s);
  void BeginPath(const Path& path, const SimplifiedPath& simple);
  void EndPath(const Path& path, bool moved_on, int64_t filament_before);
  double TurnSpeed(const Path& path, double speed_mm_s, uint8_t rest) const;
  void PrintTurn(const SimplifiedPath& simple, const SpiralTurn& turn, const MultiPolygon& below,
                 double speed_mm_s);
  void PrintScarf(const Path& path, const ScarfOptions& options, double speed_mm_s);
  std::vector<ContourPoint> ContourOf(const SimplifiedPath& simple,
                                      const RegionMotion& region) const;
  void PrintContour(const Path& path, std::span<const ContourPoint> points, double speed_mm_s);
  std::optional<RestSteps> RestUnder(const Path& path) const;
  std::vector<RestingPiece> PiecesUnder(const Path& path,
                                        std::span<const PathSegment> segments) const;
  void PrintOverAir(const SimplifiedPath& simple, RestSteps steps, double speed_mm_s);
  void PrintPiece(const Path& path, const PathSegment& piece, uint8_t rest, double speed_mm_s);
  void PrintAbove(const Path& path, const PathSegment& piece, uint8_t rest, double speed_mm_s);
  void PrintBridges(const Path& path, Point from, Point to, Coord width_nm, double speed_mm_s);
  void PrintBridge(const Path& path, Point from, Point to, Coord width_nm, double speed_mm_s,
                   bool thread);
  void PrintSegment(Point from, Point to, const Bead& bead);
  void PrintTo(Point from, Point to, const Bead& bead);
  void MoveTo(int32_t x_um, int32_t y_um);
  double MovesMm(std::span<const PointUm> points) const;
  void Retract();
  void PullBack(int32_t units);
  int32_t UnitsBeforeWipe() const;
  double WipeSpeed() const;
  int32_t WipeBack(int32_t units);
  void Restart();
  void MoveZ(int32_t z_um);
  void Push(MoveKind kind, double acceleration_mm_s2);
  FeatureUse UseOf(double length_mm, int64_t filament) const;
  void Count(const Path& path, int64_t filament);

  const MotionOptions& options_;
  bool first_layer_;
  int32_t layer_;  ///< index of the layer
  PrintSpeeds speeds_;
  Accelerations accelerations_;
  double filament_area_mm2_;
  Coord bead_height_nm_;
  int32_t bottom_um_;  ///< z of the bottom of the beads, z_offset included
  const LayerBelow* below_;
  const LayerBelow* above_supports_;
  const LayerBelow* curled_;
  SurfaceFollower* follower_ = nullptr;
  int32_t z_um_;
  int32_t lift_um_;           ///< height by which travels rise; 0 if they do not
  int32_t start_lift_um_;     ///< rise of the travel to the first path
  bool after_top_ = false;    ///< true if the last bead, except gap fill, is part of a top surface
  bool reversed_ = false;     ///< true if the current path is reversed (reversal.h)
  bool after_inner_ = false;  ///< true if the last path was an inner wall
  Wipe wipe_;
  std::vector<PointUm> wipe_path_;  ///< points of the wipe from the end of the path before
  int32_t retract_units_;           ///< length of a retraction, in 1e-5 mm
  int32_t extra_units_;   ///< filament that a restart feeds beyond the retraction, in 1e-5 mm
  int32_t pulled_units_;  ///< length of the last retraction, in 1e-5 mm

  Toolpath path_;
  Move at_;              ///< position of the nozzle, and values that the next move inherits
  double flow_ = 1;      ///< flow factor of the current path's bead sections
  Coord thread_nm_ = 0;  ///< diameter of the current path, if it is a round strand
  double print_acceleration_ = 0;  ///< acceleration of the current path
  int32_t print_feed_rate_ = 0;    ///< feed rate of the last bead; 0: none so far
  /// acceleration set in the machine; 0: unchanged since the layer before
  double set_acceleration_ = 0;
  double set_jerk_ = 0;  ///< jerk set in the machine
  bool retracted_ = true;
  /// true if the filament is still in the state in which the layer below ends
  bool as_left_ = false;
  /// true if the travel goes to an outer wall and is too short for a retraction
  bool short_travel_ = false;
  /// True if the nozzle is beyond the end of the path before, because a scarf ends over its
  /// beginning.
  bool moved_on_ = false;
  double owed_ = 0;        ///< filament remainder of rounding, in 1e-5 mm
  int64_t filament_ = 0;   ///< filament printed in total, in 1e-5 mm
  double bridged_mm_ = 0;  ///< length of the current path printed as bridges
  int64_t bridged_filament_ = 0;
  ProgramStats stats_;
};

}  // namespace slicefarm::motion
