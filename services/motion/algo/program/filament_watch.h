#pragma once

#include <algorithm>
#include <optional>
#include <string>

#include "services/motion/algo/program/gcode_machine.h"

namespace slicefarm::motion {

/// Tracks the depth of the retraction, and sums the printed filament.
class FilamentWatch {
 public:
  /// `restart_extra_mm`: if below 0, the length by which restarts may be shorter than retractions.
  /// `longest_mm`: longest move of filament only; 0: no limit.
  FilamentWatch(double restart_extra_mm, double longest_mm)
      : slack_mm_(kSlackMm + std::max(0.0, -restart_extra_mm)), longest_mm_(longest_mm) {}

  /// Adds a move. Returns the error of the move, or nullopt if there is none. `custom`: true if the
  /// move is in the user's own code, which may prime.
  std::optional<std::string> Add(const ProgramMove& move, bool custom);
  /// Changes the filament; the state is then as at the start of a program. `custom`: true if user
  /// code changes the filament. Then the filament that is retracted at this time was never printed.
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
  double depth_mm_ = 0;        ///< current depth of the retraction
  double first_depth_mm_ = 0;  ///< depth when the slicer's code began
  double last_depth_mm_ = 0;   ///< depth after the slicer's last move so far
  double printed_mm_ = 0;
  bool begun_ = false;  ///< true after the start of the slicer's code
  bool fresh_ = true;   ///< true until the first print after the start or a change of tool
};

}  // namespace slicefarm::motion
