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

/// What a machine's program needs to know.
struct ProgramOptions {
  AxisOptions axes = {};
  ToolKind tool = ToolKind::kBeam;
  double power = 1000;          ///< S: of a beam, or turns a minute
  double feed_mm_min = 1200;    ///< of the tip over the part
  double link_mm_min = 6000;    ///< of the tip, between lines
  double turn_deg_min = 7200;   ///< most of a rotary axis
  double tolerance_mm = 0.005;  ///< how far the tip may leave its way while axes turn
  double steepest_deg = 60;     ///< of the surface, for a machine without rotary axes
  double safe_mm = 20;          ///< above the highest point, before the first and after the last
  double filament_mm = 1.75;    ///< its diameter
  double layer_mm = 0.05;       ///< height of what an extruder lays down
};

/// A height of the machine's Z from which the tool sees the part below it, however it is turned.
double SafeHeight(const EngravePlan& plan, const ProgramOptions& options);

/// Writes a program of RS-274 (LinuxCNC, and most controllers of five axes) layer by layer. With
/// rotary axes each move has its own time (G93): the tip keeps its speed over the part whatever the
/// axes do for it, and moves are divided until the tip stays on its way. Angles go on from those
/// before; where C does not matter it stays. A layer begins and ends at the safe height, with the
/// angles that are next to 0: its text depends on no other layer.
class EngraveProgram {
 public:
  EngraveProgram(const ProgramOptions& options, double safe_z_mm)
      : options_(options), axes_(options.axes), safe_z_mm_(safe_z_mm) {}

  /// Units, modes, and the tool at the safe height.
  std::string Start();
  /// A layer's moves. Errors: OUT_OF_RANGE where an axis would have to go beyond its limit, or the
  /// surface is too steep for a machine without rotary axes; with the place.
  absl::StatusOr<std::string> Layer(const LayerPath& path);
  std::string End();

  const ProgramFacts& facts() const { return facts_; }

 private:
  struct Stop {
    Eigen::Vector3d place_mm = Eigen::Vector3d::Zero();  ///< of the tip, on the part
    AxisPlace axes = {};
  };

  absl::StatusOr<Stop> StopAt(const ToolPoint& point) const;
  void Approach(const Stop& stop, std::string* text);
  void Switch(bool on, std::string* text);
  void MoveTo(const Stop& stop, bool on, double spacing_mm, int depth, std::string* text);
  void WriteMove(const Stop& stop, bool on, double spacing_mm, std::string* text);

  ProgramOptions options_;
  RotaryAxes axes_;
  ProgramFacts facts_;
  Stop at_;
  double safe_z_mm_;
  double filament_rest_mm_ = 0;
  bool on_ = false;
};

}  // namespace slicefarm::texture
