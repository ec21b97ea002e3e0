#include "services/cli/render/gcode_reader.h"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "common/base/error.h"
#include "common/base/text.h"
#include "services/motion/algo/program/program_labels.h"
#include "services/motion/algo/toolpath/arc_chords.h"

namespace slicefarm::cli {
namespace {

constexpr double kDefaultFilamentMm = 1.75;
constexpr double kSecondsPerMinute = 60;
constexpr double kArcChordMm = 0.2;
constexpr double kDefaultWidthMm = 0.4;  // used until the first ;WIDTH:
/// Largest coordinate, so that sums and extents of any number of moves are finite.
constexpr double kFarthestMm = 1e9;

/// Returns true if the number is in range; NaN is not.
bool Near(double number) { return std::abs(number) <= kFarthestMm; }

/// Relevant words of a command, by letter.
struct Words {
  std::array<std::optional<double>, 26> values;

  std::optional<double> operator[](char letter) const { return values[letter - 'A']; }
};

Words ParseWords(std::string_view text) {
  Words words;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (at < end) {
    const char letter = *at++;
    if (letter < 'A' || letter > 'Z') continue;
    double number = 0;
    const auto [after, error] = std::from_chars(at, end, number);
    if (error == std::errc()) {
      if (Near(number)) words.values[letter - 'A'] = number;
      at = after;
    }
  }
  return words;
}

/// Returns the text after one of the equivalent words of PrusaSlicer and Bambu Studio; nothing if
/// there is none.
std::optional<std::string_view> After(std::string_view text,
                                      std::initializer_list<std::string_view> words) {
  for (const std::string_view word : words)
    if (text.starts_with(word)) return Trim(text.substr(word.size()));
  return std::nullopt;
}

class Reader {
 public:
  Reader(int wanted, std::span<const double> line_end_s) : line_end_s_(line_end_s) {
    layer_.index = wanted;
  }

  void Line(std::string_view line) {
    ++lines_;
    if (line.starts_with(';')) return Comment(Trim(line.substr(1)));
    line = line.substr(0, line.find(';'));
    if (line.starts_with('G') || line.starts_with('M')) Command(line);
  }

  GcodeLayer Finish() {
    EndRuns();
    // The filament's diameter is at the end of the file.
    const double filament_mm2 = std::numbers::pi / 4 * filament_mm_ * filament_mm_;
    for (BeadRun& bead : layer_.beads) bead.flow_mm3_s *= filament_mm2;
    layer_.layer_count = current_ + 1;
    const double start_s = layer_.beads.empty() ? 0 : layer_.beads.front().time_s;
    for (BeadRun& bead : layer_.beads) bead.time_s -= start_s;
    return std::move(layer_);
  }

 private:
  bool Wanted() const { return current_ == layer_.index; }

  void Comment(std::string_view text) {
    if (text.starts_with("LAYER_CHANGE") || text == "CHANGE_LAYER") {
      EndRuns();
      ++current_;
    } else if (const auto feature = After(text, {"TYPE:", "FEATURE:"})) {
      EndRuns();
      feature_ = std::string(*feature);
    } else if (const auto width = After(text, {"WIDTH:", "LINE_WIDTH:"})) {
      EndRuns();
      const double width_mm = ToNumber(*width).value_or(0);
      if (width_mm > 0 && Near(width_mm)) width_mm_ = width_mm;
    } else if (const auto given = motion::QuotedValue(text, "filament_diameter")) {
      const double mm = ToNumber(given->substr(0, given->find_first_of(",;"))).value_or(0);
      if (mm > 0 && Near(mm)) filament_mm_ = mm;
    } else if (!Wanted()) {
      return;
    } else if (const auto height = After(text, {"HEIGHT:", "LAYER_HEIGHT:"})) {
      layer_.height_mm = ToNumber(*height).value_or(0);
    } else if (const auto z = After(text, {"Z:", "Z_HEIGHT:"})) {
      layer_.z_mm = ToNumber(*z).value_or(0);
    }
  }

  void Command(std::string_view line) {
    const std::string_view code = line.substr(0, line.find(' '));
    if (code == "G1" || code == "G0") {
      Move(ParseWords(line.substr(code.size())));
    } else if (code == "G2" || code == "G3") {
      Move(ParseWords(line.substr(code.size())),
           code == "G2" ? PathShape::kClockwise : PathShape::kCounter);
    } else if (code == "G90" || code == "G91") {
      relative_ = code == "G91";
      relative_e_ = relative_;
    } else if (code == "M82" || code == "M83") {
      relative_e_ = code == "M83";
    } else if (code == "G92") {
      const Words words = ParseWords(line.substr(code.size()));
      at_ = {words['X'].value_or(at_.x()), words['Y'].value_or(at_.y())};
      e_ = words['E'].value_or(e_);
    }
  }

  enum class PathShape { kStraight, kClockwise, kCounter };

  /// Returns the ends of an arc's chords.
  std::vector<Vector2> Chords(const Words& words, Vector2 to, PathShape path) const {
    const Vector2 centre = at_ + Vector2(words['I'].value_or(0), words['J'].value_or(0));
    motion::Arc arc = {at_, to, centre, path == PathShape::kClockwise};
    if (const auto radius = words['R']; radius && at_ != to)
      arc.centre = motion::CentreByRadius(at_, to, *radius, arc.clockwise);
    return motion::ArcChords(arc, arc.StartRadius() * arc.Angle(), kArcChordMm);
  }

  void Move(const Words& words, PathShape path = PathShape::kStraight) {
    if (const auto f = words['F']; f && *f > 0 && *f / kSecondsPerMinute != speed_mm_s_) {
      EndRuns();
      speed_mm_s_ = *f / kSecondsPerMinute;
    }
    const Vector2 to = {Coordinate(words['X'], at_.x()), Coordinate(words['Y'], at_.y())};
    double pushed = 0;
    if (const auto e = words['E']) {
      pushed = relative_e_ ? *e : *e - e_;
      if (!relative_e_) e_ = *e;
    }
    if (to == at_ && path == PathShape::kStraight) {
      EndRuns();
      return;
    }
    if (Wanted()) {
      const std::vector<Vector2> ends =
          path == PathShape::kStraight ? std::vector<Vector2>{to} : Chords(words, to, path);
      for (const Vector2& end : ends) {
        Extend(pushed > 0 ? bead_ : travel_, pushed > 0, end);
        if (pushed > 0) length_mm_ += std::hypot(end.x() - at_.x(), end.y() - at_.y());
        at_ = end;
      }
      if (pushed > 0) pushed_mm_ += pushed;
    }
    at_ = to;
    if (!line_end_s_.empty()) EndRuns();
  }

  double Coordinate(std::optional<double> word, double from) const {
    if (!word.has_value()) return from;
    return relative_ ? from + *word : *word;
  }

  void Extend(std::vector<Vector2>& run, bool extruding, Vector2 to) {
    if (extruding != extruding_) EndRuns();
    extruding_ = extruding;
    if (run.empty()) run.push_back(at_);
    run.push_back(to);
  }

  void EndRuns() {
    if (!bead_.empty()) {
      const double flow = length_mm_ > 0 ? pushed_mm_ / length_mm_ * speed_mm_s_ : 0;
      const double time_s = lines_ <= line_end_s_.size() ? line_end_s_[lines_ - 1] : 0;
      layer_.beads.push_back({feature_, width_mm_, std::move(bead_), speed_mm_s_, flow, 0, time_s});
    }
    pushed_mm_ = length_mm_ = 0;
    if (!travel_.empty()) layer_.travels.push_back(std::move(travel_));
    bead_.clear();
    travel_.clear();
  }

  std::span<const double> line_end_s_;
  size_t lines_ = 0;
  GcodeLayer layer_;
  int current_ = -1;
  Vector2 at_ = Vector2::Zero();
  double e_ = 0;
  bool relative_ = false;
  bool relative_e_ = false;
  bool extruding_ = false;
  std::string feature_ = "Unknown";
  double width_mm_ = kDefaultWidthMm;
  double filament_mm_ = kDefaultFilamentMm;
  double speed_mm_s_ = 0;
  // filament that the current run of beads has used, in mm
  double pushed_mm_ = 0;
  double length_mm_ = 0;
  std::vector<Vector2> bead_;
  std::vector<Vector2> travel_;
};

}  // namespace

absl::StatusOr<GcodeLayer> ReadGcodeLayer(std::string_view gcode, int index,
                                          std::span<const double> line_end_s) {
  Reader reader(index, line_end_s);
  for (size_t begin = 0; begin < gcode.size();) {
    const size_t end = std::min(gcode.find('\n', begin), gcode.size());
    std::string_view line = gcode.substr(begin, end - begin);
    if (line.ends_with('\r')) line.remove_suffix(1);
    reader.Line(line);
    begin = end + 1;
  }
  GcodeLayer layer = reader.Finish();
  if (layer.layer_count == 0) {
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        "the file has no ;LAYER_CHANGE comment: it is not G-code of slicefarm or PrusaSlicer");
  }
  if (index < 0 || index >= layer.layer_count) {
    return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                     fmt::format("there is no layer {}: layers are numbered from 0 to {}", index,
                                 layer.layer_count - 1));
  }
  return layer;
}

}  // namespace slicefarm::cli
