#pragma once

#include <string>

#include "absl/status/statusor.h"
#include "processes/engrave/model/engrave_report.h"
#include "processes/engrave/model/engrave_settings.h"
#include "services/texture/algo/output/rotary_axes.h"
#include "services/texture/algo/paths/layer_paths.h"

namespace slicefarm::texture {

using slicefarm::ProgramFacts;
using slicefarm::ToolKind;

/// Options for a machine's program.
struct ProgramOptions {
  AxisOptions axes = {};
  ToolKind tool = ToolKind::kBeam;
  /// S word of the program: power of a beam, or turns per minute of a spindle
  double power = 1000;
  double feed_mm_min = 1200;    ///< feed of the tip over the part
  double link_mm_min = 6000;    ///< feed of the tip on links between lines
  double turn_deg_min = 7200;   ///< largest speed of a rotary axis
  double tolerance_mm = 0.005;  ///< largest deviation of the tip from its path while axes turn
  /// largest angle of the surface to the horizontal for a machine without rotary axes
  double steepest_deg = 60;
  /// Height of the tip above the part's highest point before the first and after the last move.
  double safe_mm = 20;
  double filament_mm = 1.75;  ///< diameter of the filament
  double layer_mm = 0.05;     ///< height of a layer that an extruder deposits
};

/// Returns a Z height at which the tool is above the part for all angles of the rotary axes.
double SafeHeight(const EngravePlan& plan, const ProgramOptions& options);

/// Writes a program in RS-274 (LinuxCNC and most controllers with five axes), layer by layer. With
/// rotary axes, each move has its own time (G93), so that the tip keeps its speed over the part
/// even if axes turn. Moves are divided until the tip deviates from its path by at most the
/// tolerance.
///
/// Angles of C may exceed a full turn: each is the solution closest to the previous angle. Where
/// any C is possible, C does not turn. A layer begins and ends at the safe height, with the angles
/// closest to 0, so its text depends on no other layer.
class EngraveProgram {
 public:
  EngraveProgram(const ProgramOptions& options, double safe_z_mm)
      : options_(options), axes_(options.axes), safe_z_mm_(safe_z_mm) {}

  /// Returns the first lines of the program: units, modes, and the tool at the safe height.
  std::string Start();
  /// Returns the moves of a layer. Errors, with the position: OUT_OF_RANGE if an axis would exceed
  /// its limit, or if the surface is too steep for a machine without rotary axes.
  absl::StatusOr<std::string> Layer(const LayerPath& path);
  /// Returns the end of the program.
  std::string End();

  /// Returns the facts about the moves written so far.
  const ProgramFacts& facts() const { return facts_; }

 private:
  struct AxisPose {
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  ///< position of the tip on the part
    AxisValues axes = {};
  };

  absl::StatusOr<AxisPose> PoseAt(const ToolPoint& point) const;
  void Approach(const AxisPose& pose, std::string* text);
  void Switch(bool on, std::string* text);
  void MoveTo(const AxisPose& pose, bool on, double spacing_mm, int depth, std::string* text);
  void WriteMove(const AxisPose& pose, bool on, double spacing_mm, std::string* text);

  ProgramOptions options_;
  RotaryAxes axes_;
  ProgramFacts facts_;
  AxisPose at_;
  double safe_z_mm_;
  double filament_rest_mm_ = 0;
  bool on_ = false;
};

}  // namespace slicefarm::texture
