#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/model/options/region_speeds.h"
#include "common/model/layers/layer.h"
#include "services/motion/algo/toolpath/accelerations.h"
#include "services/motion/algo/toolpath/overhang.h"
#include "services/motion/algo/toolpath/print_speed.h"
#include "services/motion/algo/toolpath/simplified_path.h"
#include "services/motion/algo/toolpath/toolpath.h"
#include "services/motion/algo/toolpath/wipe.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Turns paths into moves, one path after the other: travels with retraction and lift, beads with
/// their filament.
///
/// Paths are simplified within `resolution_nm` first (simplified_path.h): this is the one place
/// where they are, whatever they come from.
///
/// Filament is that of the bead's section (SectionMm2) times the extrusion multiplier; where the
/// width of a path varies, it is divided into segments of one width (divided_path.h). What rounding
/// leaves is carried on, so that the sum over a layer is exact to 1e-5 mm. Segments that round to
/// nothing are left out; their filament is not. Loops with a scarf (scarf.h) end further on; the
/// way from there is in sight. There are none on the first layer. A retraction wipes (wipe.h) but
/// after a scarf, which thins out by itself; travels start where the nozzle is then.
///
/// Where the block meets the layer below, the filament may be retracted or ready: the first
/// retraction or restart is done if it is needed.
class ToolpathBuilder {
 public:
  /// `options` must outlive the builder, and so must `below`, by which walls are slowed down over
  /// air; null: that is not asked for, or not known. `carried`: where supports lie right below, on
  /// which walls are no threads; null: nowhere. `bead_height_nm`: of the paths.
  ToolpathBuilder(const MotionOptions& options, const LayerFrame& frame, Coord bead_height_nm,
                  Ground ground = Ground::kLayers, const LayerBelow* below = nullptr,
                  const LayerBelow* carried = nullptr);

  /// The filament is as the layer below leaves it. To be called before anything is added.
  void BeginAsLeft() {
    retracted_ = false;
    as_left_ = true;
  }

  /// `travel`: the way to it; of the first path it is looked at after BeginAsLeft alone.
  /// `contour_mm`: that of ContourLengthsMm; none: the path's own length.
  void Add(const Path& path, const Travel& travel = {}, std::optional<double> contour_mm = {});

  /// The only bead of a layer: a loop along which the nozzle rises from the bottom of the layer to
  /// its top. Where it leads over from the turn below, which ran along the outline `below`, each
  /// point lies between the two by how far along the loop it is. The first turn grows from nothing,
  /// and over the last one a level one thins out to nothing, so that all together are as much as as
  /// many loops. `path` starts where the turn does.
  void AddTurn(const Path& path, const SpiralTurn& turn, const MultiPolygon& below);

  /// Hands over what was added, after a retraction. To be called once.
  Toolpath Finish();

  /// The same at a meeting with the layer above: the filament is retracted if the way to `leave`
  /// asks for it; without one it is ready to print.
  Toolpath FinishAt(const std::optional<Leave>& leave);

  bool retracted() const { return retracted_; }

  /// Of what was added: lengths, volumes, travels, retractions and bounds; no times.
  const ProgramStats& stats() const { return stats_; }

 private:
  /// What the segments of one width have in common.
  struct Bead {
    Coord width_nm = 0;
    double filament_per_mm = 0;  ///< in 1e-5 mm
    int32_t feed_rate = 0;
  };

  Bead BeadOf(Coord width_nm, double speed_mm_s) const;
  void Approach(Point to, const Travel& travel);
  void GoTo(Point to, const Travel& travel);
  void Rise(std::span<const PlaceUm> way);
  void PrintSegments(const SimplifiedPath& simple, double speed_mm_s);
  void BeginPath(const Path& path, const SimplifiedPath& simple);
  void EndPath(const Path& path, bool moved_on, int64_t filament_before);
  double TurnSpeed(const Path& path, double speed_mm_s, uint8_t rest) const;
  void PrintTurn(const SimplifiedPath& simple, const SpiralTurn& turn, const MultiPolygon& below,
                 double speed_mm_s);
  void PrintScarf(const Path& path, const ScarfOptions& options, double speed_mm_s);
  std::optional<RestSteps> RestUnder(const Path& path) const;
  std::vector<RestingPiece> PiecesUnder(const Path& path,
                                        std::span<const PathSegment> segments) const;
  void PrintOverAir(const SimplifiedPath& simple, RestSteps steps, double speed_mm_s);
  void PrintBridges(const Path& path, Point from, Point to, Coord width_nm, double speed_mm_s);
  void PrintBridge(const Path& path, Point from, Point to, Coord width_nm, double speed_mm_s,
                   bool thread);
  void PrintSegment(Point from, Point to, const Bead& bead);
  void PrintTo(Point from, Point to, const Bead& bead);
  void MoveTo(int32_t x_um, int32_t y_um);
  double WayMm(std::span<const PlaceUm> way) const;
  void Retract();
  void PullBack(int32_t units);
  int32_t WipeBack(int32_t units);
  void Restart();
  void MoveZ(int32_t z_um);
  void Push(MoveKind kind, double acceleration_mm_s2);
  FeatureUse UseOf(double length_mm, int64_t filament) const;
  void Count(const Path& path, int64_t filament);

  const MotionOptions& options_;
  bool first_layer_;
  PrintSpeeds speeds_;
  Accelerations accelerations_;
  double filament_area_mm2_;
  Coord bead_height_nm_;
  int32_t bottom_um_;  ///< of the beads
  const LayerBelow* below_;
  const LayerBelow* carried_;
  int32_t z_um_;
  int32_t lift_um_;        ///< where travels rise
  int32_t start_lift_um_;  ///< of the travel to the first path
  bool after_top_ = false;  ///< the last bead but for fill of gaps is a top's
  Wipe wipe_;
  std::vector<PlaceUm> wipe_way_;  ///< from the end of the path before
  int32_t retract_units_;
  int32_t restart_units_;

  Toolpath path_;
  Move at_;                        ///< where the nozzle is, and what the next move inherits
  double flow_ = 1;                ///< of the path being printed, of its beads' sections
  Coord thread_nm_ = 0;            ///< diameter of the path being printed, if it is a thread
  double print_acceleration_ = 0;  ///< of the path being printed
  double set_acceleration_ = 0;    ///< what the machine is set to; 0: as before the layer
  bool retracted_ = true;
  bool as_left_ = false;    ///< retracted or not, as the layer below has left it
  bool short_way_ = false;  ///< to an outer wall, and too short for a retraction
  bool moved_on_ = false;   ///< beyond the end of the path before: a scarf ends over its beginning
  double owed_ = 0;         ///< filament that rounding left, in 1e-5 mm
  int64_t filament_ = 0;    ///< printed in all, in 1e-5 mm
  double bridged_mm_ = 0;   ///< of the path being printed, as bridges
  int64_t bridged_filament_ = 0;
  ProgramStats stats_;
};

}  // namespace slicefarm::motion
