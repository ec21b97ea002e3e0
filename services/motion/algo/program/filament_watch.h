#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// Tracks the retracted length of filament, and sums the printed filament.
class FilamentWatch {
 public:
  /// `restart_extra_mm`: if below 0, restarts may be shorter than retractions by its absolute
  /// value. `longest_mm`: longest permitted move in which only the filament moves; 0: no limit.
  FilamentWatch(double restart_extra_mm, double longest_mm)
      : slack_mm_(kSlackMm + std::max(0.0, -restart_extra_mm)), longest_mm_(longest_mm) {}

  /// Adds a move. Returns the error of the move, or nullopt if there is none. `custom`: true if the
  /// move is in the user's own code, which may prime.
  std::optional<std::string> Add(const ProgramMove& move, bool custom);
  /// Changes the filament; the new one starts as at the start of a program. `custom`: true if
  /// custom G-code changes it. If not, the filament that is retracted at this time counts as
  /// printed.
  void ChangeTool(bool custom);

  /// Returns the length of filament that the slicer prints: extrusions less retractions, without
  /// custom code and without the slicer's retraction at the end.
  double PrintedMm() const { return printed_mm_ + last_depth_mm_ - first_depth_mm_; }

 private:
  static constexpr double kSlackMm = 0.01;

  std::optional<std::string> Print();
  std::optional<std::string> Restart(double mm);

  double slack_mm_;
  double longest_mm_;
  double depth_mm_ = 0;        ///< length of filament that is retracted now, in mm
  double first_depth_mm_ = 0;  ///< retracted length when the slicer's code began
  double last_depth_mm_ = 0;   ///< retracted length after the slicer's last move so far
  double printed_mm_ = 0;
  bool begun_ = false;  ///< true after the start of the slicer's code
  bool fresh_ = true;   ///< true until the first bead after the start or after a tool change
};

}  // namespace slicefarm::motion
