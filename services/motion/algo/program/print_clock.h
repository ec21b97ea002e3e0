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

/// The time of a whole print, put together from its layers' own times and what lies between them.
///
/// A layer's times are from rest to rest, as if it were alone. Where layers meet, the moves at
/// their edges are planned once more, together with the way between them, and what that differs by
/// is put right. So the sums are those of the whole program's look-ahead (exactly so where the
/// firmware stops for the filament), and do not depend on how layers were shared out.
class PrintClock {
 public:
  PrintClock(const ProgramSummary& summary, const MotionOptions& options);
  PrintClock(const PrintClock&) = delete;
  PrintClock& operator=(const PrintClock&) = delete;

  /// In the order of printing: what stands before the layers, before layer `i`, after the layers.
  void ReadBefore(std::string_view gcode) { Read(gcode, times_.before_s); }
  void ReadAt(size_t i, std::string_view gcode) { Read(gcode, times_.layer_s[i]); }
  void ReadAfter(std::string_view gcode) { Read(gcode, times_.after_s); }
  void AddLayer(size_t i);

  PrintTimes Finish();

 private:
  /// The sums that a move's time is added to.
  struct Account {
    double* kind_s;
    double* part_s;
  };

  void Read(std::string_view gcode, double& part_s);
  void ReadLine(std::string_view text, double& part_s);
  void Rest(const GcodeLine& line, double& part_s);
  void Resume();
  /// Queues the moves of `way` after its first place.
  void Queue(std::span<const EdgeMove> way, double set_mm_s2, double& part_s);
  void QueueHead(const LayerEdges& edges, double& part_s);
  void Queue(const EdgeMove& before, const EdgeMove& move, double set_mm_s2, double& part_s);
  /// Plans what is queued and adds its times, `sign` times.
  void Stop(double sign = 1);

  const ProgramSummary& summary_;
  const Firmware& firmware_;
  GcodeMachine machine_;
  HeatWaits heat_;
  std::unique_ptr<Planner> planner_;
  std::vector<Account> accounts_;
  EdgeMove at_;
  double set_mm_s2_ = 0;  ///< acceleration that the machine is set to
  PrintTimes times_;
};

}  // namespace slicefarm::motion
