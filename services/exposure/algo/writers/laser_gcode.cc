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

/// The moves of a layer; says speed and power where they change.
class MoveText {
 public:
  MoveText(const FileFacts& facts, std::string& text) : facts_(facts), text_(text) {}

  void SetStyle(const ExposureStyle& style) {
    feed_ = std::llround(style.speed_mm_s * 60 * 10);
    power_ =
        std::llround(style.power_w / facts_.output.full_power_w * facts_.output.full_power_s * 100);
  }

  void Jump(Point p) {
    if (at_set_ && p == at_) return;
    text_ += "G0";
    Place(p);
    if (said_power_ != 0) text_ += " S0";
    said_power_ = 0;
    text_ += '\n';
  }
  void Expose(Point p) { Move(p, power_); }
  void Run(Point p) {
    if (p != at_) Move(p, 0);
  }

 private:
  void Move(Point p, int64_t power) {
    text_ += "G1";
    Place(p);
    if (said_feed_ != feed_) {
      text_ += " F";
      AppendDecimal(text_, feed_, 1);
    }
    if (said_power_ != power) {
      text_ += " S";
      AppendDecimal(text_, power, 2);
    }
    said_feed_ = feed_;
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
  std::string& text_;
  int64_t feed_ = 0, power_ = 0;             ///< of the style: mm/min * 10, S * 100
  int64_t said_feed_ = -1, said_power_ = 0;  ///< the layer starts with S0
  Point at_;
  bool at_set_ = false;
};

void AppendGroup(const ExposureGroup& group, Point shift, MoveText& moves) {
  group.ForEachLine([&](std::span<const Point> line) {
    moves.Jump(Beyond(line[1], line[0], group.run_nm) + shift);
    moves.Run(line[0] + shift);
    for (const Point p : line.subspan(1)) moves.Expose(p + shift);
    moves.Run(Beyond(line[line.size() - 2], line.back(), group.run_nm) + shift);
  });
}

}  // namespace

std::string LaserGcodeHeader(const FileFacts& facts) {
  std::string text = fmt::format("; slicefarm, laser, {}, {} layers\n",
                                 IsMarlin(facts) ? "Marlin" : "grbl", facts.layers);
  for (size_t settings = 0; settings < facts.regions.size(); ++settings)
    for (size_t kind = 0; kind < kExposureKindCount; ++kind)
      text += fmt::format("; settings {} {}\n", settings, StyleText(facts.regions[settings], kind));
  text += "G21\nG90\n";
  if (!IsMarlin(facts)) text += "G94\n";
  return text + OffCommand(facts);
}

std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts) {
  std::string text = fmt::format("; layer {}\nG0 Z", layer.frame.index);
  AppendMm(text, layer.frame.print_z_nm, kDecimals);
  text += '\n';
  text += OnCommand(facts);
  MoveText moves(facts, text);
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      moves.SetStyle(facts.regions[static_cast<size_t>(group.settings)].StyleOf(group.kind));
      AppendGroup(group, visit.shift, moves);
    }
  }
  return text + OffCommand(facts);
}

std::string LaserGcodeFooter(const FileFacts& facts) {
  return std::string(OffCommand(facts)) + (IsMarlin(facts) ? "" : "M2\n");
}

}  // namespace slicefarm::exposure
