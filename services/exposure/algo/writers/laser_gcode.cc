#include "services/exposure/algo/writers/laser_gcode.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>

#include "services/exposure/algo/scan/skywriting.h"
#include "services/exposure/algo/writers/number_text.h"
#include "services/exposure/algo/writers/style_text.h"

namespace slicefarm::exposure {
namespace {

constexpr int kDecimals = 4;  ///< of mm: a tenth of a micrometre

bool IsMarlin(const FileFacts& facts) { return facts.output.format == OutputFormat::kMarlin; }

const char* OnCommand(const FileFacts& facts) {
  if (IsMarlin(facts)) return facts.output.dynamic_power ? "M4 I S0\n" : "M3 I S0\n";
  return facts.output.dynamic_power ? "M4 S0\n" : "M3 S0\n";
}
const char* OffCommand(const FileFacts& facts) { return IsMarlin(facts) ? "M5 I\n" : "M5\n"; }

/// The moves of a layer; says speed, power and focus where they change.
class MoveText {
 public:
  /// The head is at `layer_z_nm`, the laser on with S0.
  MoveText(const FileFacts& facts, Coord layer_z_nm, std::string& text)
      : facts_(facts), layer_z_nm_(layer_z_nm), said_z_nm_(layer_z_nm), text_(text) {}

  void SetStyle(const ExposureStyle& style, const JumpOptions& jump) {
    feed_ = FeedOf(style.speed_mm_s);
    jump_feed_ = FeedOf(jump.speed_mm_s);
    power_ =
        std::llround(style.power_w / facts_.output.full_power_w * facts_.output.full_power_s * 100);
    SetHeight(layer_z_nm_ + FromMm(style.focus_mm));
  }

  void Jump(Point p, double delay_us) {
    if (at_set_ && p == at_) return;
    text_ += "G0";
    Place(p);
    if (IsMarlin(facts_)) Feed(jump_feed_);
    if (said_power_ != 0) text_ += " S0";
    said_power_ = 0;
    text_ += '\n';
    Wait(delay_us);
  }
  void Expose(Point p) { Move(p, power_); }
  void Run(Point p) {
    if (p != at_) Move(p, 0);
  }

  /// With the laser off: M4 has it so wherever the head stands still, M3 has not.
  void Wait(double delay_us) {
    if (!(delay_us > 0)) return;
    const bool off = !facts_.output.dynamic_power && said_power_ != 0;
    if (off) text_ += OffCommand(facts_);
    text_ += "G4 P";
    if (IsMarlin(facts_))
      AppendDecimal(text_, static_cast<int64_t>(std::ceil(delay_us / 1000)), 0);
    else
      AppendDecimal(text_, std::llround(delay_us), 6);
    text_ += '\n';
    if (off) On();
  }

 private:
  static int64_t FeedOf(double speed_mm_s) { return std::llround(speed_mm_s * 60 * 10); }

  void On() {
    text_ += OnCommand(facts_);
    said_power_ = 0;
  }

  void SetHeight(Coord z_nm) {
    if (z_nm == said_z_nm_) return;
    said_z_nm_ = z_nm;
    text_ += OffCommand(facts_);
    text_ += "G0 Z";
    AppendMm(text_, z_nm, kDecimals);
    text_ += '\n';
    On();
  }

  void Feed(int64_t feed) {
    if (said_feed_ == feed) return;
    text_ += " F";
    AppendDecimal(text_, feed, 1);
    said_feed_ = feed;
  }

  void Move(Point p, int64_t power) {
    text_ += "G1";
    Place(p);
    Feed(feed_);
    if (said_power_ != power) {
      text_ += " S";
      AppendDecimal(text_, power, 2);
    }
    said_power_ = power;
    text_ += '\n';
  }
  void Place(Point p) {
    text_ += " X";
    AppendMm(text_, p.x, kDecimals);
    text_ += " Y";
    AppendMm(text_, p.y, kDecimals);
    at_ = p;
    at_set_ = true;
  }

  const FileFacts& facts_;
  const Coord layer_z_nm_;
  Coord said_z_nm_;
  std::string& text_;
  int64_t feed_ = 0, jump_feed_ = 0, power_ = 0;  ///< of the style: mm/min * 10, S * 100
  int64_t said_feed_ = -1, said_power_ = 0;
  Point at_;
  bool at_set_ = false;
};

void AppendGroup(const ExposureGroup& group, Point shift, const JumpOptions& jump,
                 MoveText& moves) {
  group.ForEachLine([&](std::span<const Point> line) {
    moves.Jump(Beyond(line[1], line[0], group.run_nm) + shift, jump.delay_us);
    moves.Run(line[0] + shift);
    for (size_t i = 1; i < line.size(); ++i) {
      moves.Expose(line[i] + shift);
      if (i + 1 < line.size()) moves.Wait(jump.polygon_delay_us);
    }
    moves.Run(Beyond(line[line.size() - 2], line.back(), group.run_nm) + shift);
    if (group.run_nm == 0) moves.Wait(jump.mark_delay_us);
  });
}

}  // namespace

std::string LaserGcodeHeader(const FileFacts& facts) {
  std::string text = fmt::format("; slicefarm, laser, {}, {} layers\n",
                                 IsMarlin(facts) ? "Marlin" : "grbl", facts.layers);
  for (size_t settings = 0; settings < facts.regions.size(); ++settings)
    for (size_t kind = 0; kind < kExposureKindCount; ++kind)
      text += fmt::format("; settings {} {}\n", settings, StyleText(facts.regions[settings], kind));
  text += facts.start_code;
  text += "G21\nG90\n";
  if (!IsMarlin(facts)) text += "G94\n";
  return text + OffCommand(facts);
}

std::string LaserGcodeLayerHead(const LayerFrame& layer, const LayerCode& code) {
  std::string text = code.before + fmt::format("; layer {}\nG0 Z", layer.index);
  AppendMm(text, layer.print_z_nm, kDecimals);
  text += '\n';
  return text + code.after;
}

std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts) {
  std::string text = OnCommand(facts);
  MoveText moves(facts, layer.frame.print_z_nm, text);
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      const ExposureOptions& options = facts.regions[static_cast<size_t>(group.settings)];
      moves.SetStyle(options.StyleOf(group.kind), options.jump);
      AppendGroup(group, visit.shift, options.jump, moves);
    }
  }
  return text + OffCommand(facts);
}

std::string LaserGcodeFooter(const FileFacts& facts) {
  std::string text = OffCommand(facts);
  text += facts.end_code;
  return text + (IsMarlin(facts) ? "" : "M2\n");
}

}  // namespace slicefarm::exposure
