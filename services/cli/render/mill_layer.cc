#include "services/cli/render/mill_layer.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "common/base/error.h"

namespace slicefarm::cli {
namespace {

constexpr std::string_view kFirstWords = "; tool ";
constexpr double kFarthestTravelMm = 1e9;
constexpr double kChordMm = 0.2;
/// Width of a drawn toolpath, as a share of the picture's longer side.
constexpr double kPathShare = 1.0 / 800;
/// Heights are whole micrometres.
constexpr double kUmPerMm = 1000;
/// Smallest length of a toolpath that counts as level. A ramp's chord that falls by less than a
/// micrometre seems level, but is shorter.
constexpr double kLeastLevelMm = 1;

/// Toolpath in x and y at one height, or a toolpath that changes its height.
struct DrawnPath {
  std::string phase;
  bool rapid = false;
  std::optional<int64_t> height_um;  ///< empty: not level
  std::vector<Vector2> points;
};

class PathReader {
 public:
  void Line(std::string_view line) {
    if (line.starts_with('(')) {
      EndRoute();
      phase_ = line.substr(1, line.find(')') - 1);
      return;
    }
    std::array<std::optional<double>, 26> words;
    Read(line.substr(0, line.find(';')), words);
    const auto word = [&](char letter) { return words[static_cast<size_t>(letter - 'A')]; };
    const Vector2 to = {word('X').value_or(at_.x()), word('Y').value_or(at_.y())};
    const double z = word('Z').value_or(z_);
    const bool arc = kind_ >= 2 && (word('I') || word('J'));
    if (to != at_ || arc) Move(to, z, {word('I').value_or(0), word('J').value_or(0)}, arc);
    if (z != z_) EndRoute();
    at_ = to;
    z_ = z;
  }

  std::vector<DrawnPath> Finish() {
    EndRoute();
    return std::move(paths_);
  }

 private:
  /// Reads the words of a line into `words`, indexed by letter. Stores the last command of G0 to
  /// G3, because it applies to later lines without a command.
  void Read(std::string_view line, std::array<std::optional<double>, 26>& words) {
    const char* at = line.data();
    const char* const end = at + line.size();
    while (at < end) {
      const char letter = *at++;
      if (letter < 'A' || letter > 'Z') continue;
      double number = 0;
      const auto [after, error] = std::from_chars(at, end, number);
      if (error != std::errc() || !(std::abs(number) <= kFarthestTravelMm)) continue;
      at = after;
      if (letter == 'G' && number >= 0 && number <= 3) kind_ = static_cast<int>(number);
      words[static_cast<size_t>(letter - 'A')] = number;
    }
  }

  void Move(Vector2 to, double z, Vector2 centre, bool arc) {
    const bool rapid = kind_ == 0;
    const bool level = z == z_;
    if (path_.points.empty() || path_.rapid != rapid || path_.height_um.has_value() != level) {
      EndRoute();
      path_.phase = phase_;
      path_.rapid = rapid;
      if (level) path_.height_um = std::llround(z * kUmPerMm);
      path_.points.push_back(at_);
    }
    if (arc) AddArc(to, at_ + centre);
    path_.points.push_back(to);
  }

  /// Adds the chords of an arc without the end of the last one.
  void AddArc(Vector2 to, Vector2 centre) {
    const double radius = std::hypot(at_.x() - centre.x(), at_.y() - centre.y());
    const double from = std::atan2(at_.y() - centre.y(), at_.x() - centre.x());
    double turn = std::atan2(to.y() - centre.y(), to.x() - centre.x()) - from;
    if (kind_ == 2 && turn >= 0) turn -= 2 * std::numbers::pi;
    if (kind_ == 3 && turn <= 0) turn += 2 * std::numbers::pi;
    const double chords = std::clamp(std::ceil(std::abs(turn) * radius / kChordMm), 1.0, 1000.0);
    for (double k = 1; k < chords; ++k) {
      const double angle = from + turn * k / chords;
      path_.points.push_back(
          {centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)});
    }
  }

  void EndRoute() {
    if (path_.points.size() > 1) paths_.push_back(std::move(path_));
    path_ = {};
  }

  std::vector<DrawnPath> paths_;
  DrawnPath path_;
  std::string phase_ = "entry";
  int kind_ = 0;
  Vector2 at_ = Vector2::Zero();
  double z_ = 0;
};

double LongerSide(const std::vector<DrawnPath>& paths) {
  Vector2 low = {kFarthestTravelMm, kFarthestTravelMm},
          high = {-kFarthestTravelMm, -kFarthestTravelMm};
  for (const DrawnPath& path : paths) {
    if (path.rapid) continue;
    for (const Vector2& p : path.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  return std::max({high.x() - low.x(), high.y() - low.y(), 1.0});
}

double LengthMm(const std::vector<Vector2>& points) {
  double length = 0;
  for (size_t i = 1; i < points.size(); ++i)
    length += std::hypot(points[i].x() - points[i - 1].x(), points[i].y() - points[i - 1].y());
  return length;
}

/// Returns the heights with cuts, from the top down, without rest areas.
std::vector<int64_t> LevelsOf(const std::vector<DrawnPath>& paths) {
  std::map<int64_t, double, std::greater<>> length_mm;
  for (const DrawnPath& path : paths)
    if (!path.rapid && path.height_um && path.phase != "rest areas")
      length_mm[*path.height_um] += LengthMm(path.points);
  std::vector<int64_t> levels;
  for (const auto& [height_um, length] : length_mm)
    if (length >= kLeastLevelMm) levels.push_back(height_um);
  return levels;
}

absl::Status Refused(std::string_view message) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed, message);
}

}  // namespace

bool IsMillProgram(std::string_view gcode) { return gcode.starts_with(kFirstWords); }

absl::StatusOr<GcodeLayer> ReadMillLayer(std::string_view gcode, std::optional<int> level) {
  PathReader reader;
  for (size_t begin = 0; begin < gcode.size();) {
    const size_t end = std::min(gcode.find('\n', begin), gcode.size());
    reader.Line(gcode.substr(begin, end - begin));
    begin = end + 1;
  }
  std::vector<DrawnPath> paths = reader.Finish();
  const std::vector<int64_t> levels = LevelsOf(paths);
  if (levels.empty()) return Refused("the program cuts nothing");
  if (level && (*level < 0 || *level >= std::ssize(levels)))
    return Refused(fmt::format("there is no level {}: levels are numbered from 0 to {}", *level,
                               levels.size() - 1));
  GcodeLayer layer;
  layer.index = level.value_or(0);
  layer.layer_count = static_cast<int>(levels.size());
  const double width_mm = kPathShare * LongerSide(paths);
  const int64_t height_um = level ? levels[static_cast<size_t>(*level)] : levels.front();
  layer.z_mm = static_cast<double>(height_um) / kUmPerMm;
  layer.height_mm = static_cast<double>(height_um - levels.back()) / kUmPerMm;
  for (DrawnPath& path : paths) {
    if (level && path.height_um != height_um) continue;
    if (path.rapid) {
      layer.travels.push_back(std::move(path.points));
    } else {
      layer.beads.push_back({std::move(path.phase), width_mm, std::move(path.points)});
    }
  }
  return layer;
}

}  // namespace slicefarm::cli
