#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// Follows how deep the filament is retracted, and adds up what is printed.
class FilamentWatch {
 public:
  /// `restart_extra_mm`: what restarts leave out, if below 0. `longest_mm`: of filament alone; 0: no
  /// limit.
  FilamentWatch(double restart_extra_mm, double longest_mm)
      : slack_mm_(kSlackMm + std::max(0.0, -restart_extra_mm)), longest_mm_(longest_mm) {}

  /// What is wrong with a move; nothing if all is well. `custom`: the user's own, which may prime.
  std::optional<std::string> Add(const ProgramMove& move, bool custom);
  /// Another filament: as at the start of a program. What `custom` code has pulled back before was
  /// never printed.
  void ChangeTool(bool custom);

  /// What the slicer prints: net of retractions, without custom code and what that retracts in the
  /// end.
  double PrintedMm() const { return printed_mm_ + last_depth_mm_ - first_depth_mm_; }

 private:
  static constexpr double kSlackMm = 0.01;

  std::optional<std::string> Print();
  std::optional<std::string> Restart(double mm);

  double slack_mm_;
  double longest_mm_;
  double depth_mm_ = 0;        ///< retracted by so much
  double first_depth_mm_ = 0;  ///< when the slicer's code began
  double last_depth_mm_ = 0;   ///< after the slicer's last move so far
  double printed_mm_ = 0;
  bool begun_ = false;         ///< the slicer's code
  bool fresh_ = true;          ///< nothing printed since the start or the change of tool
};

}  // namespace slicefarm::motion
