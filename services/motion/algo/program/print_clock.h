#pragma once

#include <array>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "common/kinematics/planner.h"
#include "common/model/layers/program_summary.h"
#include "services/motion/algo/program/gcode_machine.h"
#include "services/motion/algo/program/heat_waits.h"

namespace slicefarm {
struct MotionOptions;
}  // namespace slicefarm

namespace slicefarm::motion {

/// Computes the time of a whole print from the layers' own times and the moves between the layers.
///
/// A layer's own times assume a standstill before and after the layer. Between two layers, the
/// clock plans the moves at their ends (LayerEdges) again, together with the travel between them.
/// It adds the difference to the layers' times. So the sums equal a look-ahead over the whole
/// program. The sums are exact if the firmware stops for moves in which only the filament moves.
/// The assignment of layers to workers does not change them.
class PrintClock {
 public:
  PrintClock(const ProgramSummary& summary, const MotionOptions& options);
  PrintClock(const PrintClock&) = delete;
  PrintClock& operator=(const PrintClock&) = delete;

  /// Adds the time of `gcode`, which is printed before the first layer. Call ReadBefore, ReadAt,
  /// AddLayer and ReadAfter in the order of printing.
  void ReadBefore(std::string_view gcode) { Read(gcode, times_.before_s); }
  /// Adds the time of `gcode`, which is printed just before layer `i`.
  void ReadAt(size_t i, std::string_view gcode) { Read(gcode, times_.layer_s[i]); }
  /// Adds the time of `gcode`, which is printed after the last layer.
  void ReadAfter(std::string_view gcode) { Read(gcode, times_.after_s); }
  /// Adds the time of layer `i`, corrected for the moves before it. Call in the order of printing.
  void AddLayer(size_t i);

  /// Returns the times of the whole print.
  PrintTimes Finish();

 private:
  /// Sums (by kind of move, and by part of the program) to which the time of a queued move is
  /// added.
  struct Account {
    double* kind_s;
    double* part_s;
    double* copy_s;
  };

  void Read(std::string_view gcode, double& part_s);
  void ReadLine(std::string_view text, double& part_s);
  void Rest(const GcodeLine& line, double& part_s);
  void Resume();
  /// Queues the moves of `travel`; its first element is only the start position. `set_mm_s2`:
  /// acceleration of moves without one of their own.
  void Queue(std::span<const EdgeMove> travel, double set_mm_s2, double& part_s);
  void QueueHead(const LayerEdges& edges, double& part_s);
  void Queue(const EdgeMove& before, const EdgeMove& move, double set_mm_s2, double& part_s);
  /// Returns the sum for the time of a copy.
  double* CopySum(int32_t copy);
  /// Plans the queued moves and adds their times, multiplied by `sign`.
  void Stop(double sign = 1);

  const ProgramSummary& summary_;
  const Firmware& firmware_;
  GcodeMachine machine_;
  HeatWaits heat_;
  std::unique_ptr<Planner> planner_;
  std::vector<Account> accounts_;
  EdgeMove at_;
  double set_mm_s2_ = 0;  ///< acceleration that is set in the machine
  PrintTimes times_;
  double shared_s_ = 0;  ///< time of moves that belong to no copy
};

}  // namespace slicefarm::motion
