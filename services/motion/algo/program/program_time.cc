#include "services/motion/algo/program/program_time.h"

#include <algorithm>

#include "services/motion/algo/program/program_labels.h"

namespace slicefarm::motion {
namespace {

class Clock {
 public:
  Clock(const Firmware& firmware, const MachineSetup& setup)
      : firmware_(firmware),
        machine_(firmware, setup),
        heat_(setup.heating),
        planner_(firmware.MakePlanner(setup.limits)) {}

  void Read(std::string_view text) {
    ++lines_;
    const GcodeLine line = ParseGcodeLine(text);
    if (!line.comment.empty() && labels_.Read(line.comment)) Label();
    const GcodeAction action = machine_.Read(line);
    switch (action.kind) {
      case GcodeAction::Kind::kMoves:
        for (const ProgramMove& move : action.moves) Add(move);
        break;
      case GcodeAction::Kind::kDwell:
        Stop();
        time_.dwell_s += action.dwell_s;
        LayerTime() += action.dwell_s;
        break;
      case GcodeAction::Kind::kRest:
        Stop();
        Count(line);
        break;
      case GcodeAction::Kind::kLimits:
        planner_->SetLimits(machine_.limits());
        heat_.Read(line, time_.TotalS());
        break;
      case GcodeAction::Kind::kNone:
        break;
    }
  }

  ProgramTime Finish() {
    Stop();
    FillLines(lines_);
    return std::move(time_);
  }

 private:
  /// Sums to which the time of a queued move is added.
  struct Account {
    double* kind_s;
    int layer;
    size_t line;
  };

  void Label() {
    feature_s_ = nullptr;
    const auto layers = static_cast<size_t>(labels_.layer() + 1);
    if (time_.layer_s.size() < layers) time_.layer_s.resize(layers);
  }

  double& LayerTime() { return TimeOf(labels_.layer()); }
  double& TimeOf(int layer) {
    return layer < 0 ? time_.before_s : time_.layer_s[static_cast<size_t>(layer)];
  }

  double* KindOf(const ProgramMove& move) {
    if (!move.Prints()) return move.InSpace() ? &time_.travel_s : &time_.retract_s;
    if (feature_s_ == nullptr) feature_s_ = &time_.feature_s[labels_.feature()];
    return feature_s_;
  }

  void Add(const ProgramMove& move) {
    accounts_.push_back({KindOf(move), labels_.layer(), lines_});
    planner_->Add(ToKinematic(move, firmware_, machine_.limits()));
    ++time_.moves;
    if (!move.InSpace() && firmware_.StopsForFilament()) Stop();  // limits the memory
  }

  void Stop() {
    const auto profiles = planner_->Stop();
    for (size_t i = 0; i < profiles.size(); ++i) {
      const double t = profiles[i].time_s;
      time_.move_s += t;
      *accounts_[i].kind_s += t;
      TimeOf(accounts_[i].layer) += t;
      FillLines(accounts_[i].line - 1);
      ended_s_ = time_.TotalS();
    }
    accounts_.clear();
  }

  /// Sets the end time of lines without moves to the end of the line before.
  void FillLines(size_t count) {
    if (time_.line_end_s.size() < count) time_.line_end_s.resize(count, ended_s_);
  }

  void Count(const GcodeLine& line) {
    if (line.letter == 'T') ++time_.tool_changes;
    if (line.letter == 'G') ++time_.homings;
    const auto wait_s = heat_.Read(line, time_.TotalS());
    if (!wait_s) ++time_.heat_waits;
    time_.heating_s += wait_s.value_or(0);
    LayerTime() += wait_s.value_or(0);
  }

  const Firmware& firmware_;
  GcodeMachine machine_;
  HeatWaits heat_;
  std::unique_ptr<Planner> planner_;
  ProgramLabels labels_;
  std::vector<Account> accounts_;
  size_t lines_ = 0;             ///< number of lines read
  double ended_s_ = 0;           ///< end time of the planned moves
  double* feature_s_ = nullptr;  ///< sum of the current feature
  ProgramTime time_;
};

}  // namespace

ProgramTime TimeOfProgram(std::string_view gcode, const Firmware& firmware,
                          const MachineSetup& setup) {
  Clock clock(firmware, setup);
  while (!gcode.empty()) {
    const size_t end = std::min(gcode.find('\n'), gcode.size());
    clock.Read(gcode.substr(0, end));
    gcode.remove_prefix(std::min(end + 1, gcode.size()));
  }
  return clock.Finish();
}

}  // namespace slicefarm::motion
