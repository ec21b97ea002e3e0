#include "services/exposure/algo/writers/laser_gcode.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "common/gcode/dialect.h"
#include "common/gcode/gcode_text.h"
#include "common/gcode/modal.h"
#include "services/exposure/algo/scan/skywriting.h"
#include "services/exposure/algo/writers/style_text.h"

namespace slicefarm::exposure {
namespace {

constexpr int kDecimals = 4;  ///< decimals of mm: a tenth of a micrometre

const gcode::Dialect& DialectOf(const FileFacts& facts) {
  return gcode::DialectOf(facts.output.format == OutputFormat::kMarlin ? gcode::Controller::kMarlin
                                                                       : gcode::Controller::kGrbl);
}

const char* OnCommand(const FileFacts& facts) {
  if (DialectOf(facts).inline_power) return facts.output.dynamic_power ? "M4 I S0\n" : "M3 I S0\n";
  return facts.output.dynamic_power ? "M4 S0\n" : "M3 S0\n";
}
const char* OffCommand(const FileFacts& facts) {
  return DialectOf(facts).inline_power ? "M5 I\n" : "M5\n";
}

/// Writer of a layer's moves. Writes speed, power and focus only when they change.
class MoveText {
 public:
  /// Starts a layer: the head is at `layer_z_nm`, and the laser is on with S0.
  MoveText(const FileFacts& facts, Coord layer_z_nm, GcodeText& out)
      : facts_(facts),
        dialect_(DialectOf(facts)),
        layer_z_nm_(layer_z_nm),
        z_nm_(layer_z_nm),
        out_(out) {}

  void SetStyle(const ExposureStyle& style, const JumpOptions& jump) {
    feed_ = FeedOf(style.speed_mm_s);
    jump_feed_ = FeedOf(jump.speed_mm_s);
    power_ =
        std::llround(style.power_w / facts_.output.full_power_w * facts_.output.full_power_s * 100);
    SetHeight(layer_z_nm_ + FromMm(style.focus_mm));
  }

  void Jump(Point p, double delay_us) {
    if (at_ == p) return;
    out_ << "G0";
    Place(p);
    if (dialect_.inline_power) Feed(jump_feed_);  // grbl's G0 has no feed
    if (said_power_.Changes(0)) out_ << " S0";
    out_ << '\n';
    Wait(delay_us);
  }
  void Expose(Point p) { Move(p, power_); }
  void Run(Point p) {
    if (at_ != p) Move(p, 0);
  }

  /// Writes a pause with the laser off. M4 turns the laser off whenever the head does not move; M3
  /// needs S0.
  void Wait(double delay_us) {
    if (!(delay_us > 0)) return;
    const bool off = !facts_.output.dynamic_power && !said_power_.Is(0);
    if (off) out_ << OffCommand(facts_);
    gcode::WriteDwell(dialect_, delay_us, out_);
    if (off) On();
  }

 private:
  static int64_t FeedOf(double speed_mm_s) { return std::llround(speed_mm_s * 60 * 10); }

  void On() {
    out_ << OnCommand(facts_);
    said_power_.Changes(0);
  }

  void SetHeight(Coord z_nm) {
    if (!z_nm_.Changes(z_nm)) return;
    out_ << OffCommand(facts_) << "G0 Z";
    out_.Mm(z_nm, kDecimals) << '\n';
    On();
  }

  void Feed(int64_t feed) {
    if (said_feed_.Changes(feed)) (out_ << " F").Decimal(feed, 1);
  }

  void Move(Point p, int64_t power) {
    out_ << "G1";
    Place(p);
    Feed(feed_);
    if (said_power_.Changes(power)) (out_ << " S").Decimal(power, 2);
    out_ << '\n';
  }
  void Place(Point p) {
    (out_ << " X").Mm(p.x, kDecimals);
    (out_ << " Y").Mm(p.y, kDecimals);
    at_ = p;
  }

  const FileFacts& facts_;
  const gcode::Dialect& dialect_;
  const Coord layer_z_nm_;
  gcode::Modal<Coord> z_nm_;
  GcodeText& out_;
  int64_t feed_ = 0, jump_feed_ = 0, power_ = 0;  ///< values of the style: mm/min * 10, S * 100
  gcode::Modal<int64_t> said_feed_;
  gcode::Modal<int64_t> said_power_{0};
  std::optional<Point> at_;
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
  const gcode::Dialect& dialect = DialectOf(facts);
  GcodeText out;
  out << fmt::format("; slicefarm, laser, {}, {} layers\n", dialect.name, facts.layers);
  for (size_t settings = 0; settings < facts.regions.size(); ++settings)
    for (size_t kind = 0; kind < kExposureKindCount; ++kind)
      out << fmt::format("; settings {} {}\n", settings, StyleText(facts.regions[settings], kind));
  out << facts.start_code;
  gcode::WriteUnits(dialect, out);
  out << OffCommand(facts);
  return out.Take();
}

std::string LaserGcodeLayerHead(const LayerFrame& layer, const LayerCode& code) {
  GcodeText out;
  out << code.before << "; layer ";
  out.Integer(layer.index) << "\nG0 Z";
  out.Mm(layer.print_z_nm, kDecimals) << '\n' << code.after;
  return out.Take();
}

std::string LaserGcodeLayer(const ExposedLayer& layer, const FileFacts& facts) {
  GcodeText out;
  out << OnCommand(facts);
  MoveText moves(facts, layer.frame.print_z_nm, out);
  for (const ExposureVisit& visit : layer.visits) {
    for (const ExposureGroup& group : layer.groups) {
      if (group.object != visit.object) continue;
      const ExposureOptions& options = facts.regions[static_cast<size_t>(group.settings)];
      moves.SetStyle(options.StyleOf(group.kind), options.jump);
      AppendGroup(group, visit.shift, options.jump, moves);
    }
  }
  out << OffCommand(facts);
  return out.Take();
}

std::string LaserGcodeFooter(const FileFacts& facts) {
  GcodeText out;
  out << OffCommand(facts) << facts.end_code;
  gcode::WriteProgramEnd(DialectOf(facts), out);
  return out.Take();
}

}  // namespace slicefarm::exposure
