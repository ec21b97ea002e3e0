#include "services/texture/algo/output/engrave_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "common/base/error.h"
#include "common/base/portable_math.h"

namespace slicefarm::texture {
namespace {

constexpr int kMostHalvings = 12;
constexpr double kShortestSeconds = 1e-5;

absl::Status OutOfReach(const Eigen::Vector3d& place, std::string_view why) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kOutOfRange,
                   fmt::format("the tool cannot reach ({:.3f}, {:.3f}, {:.3f}): {}", place.x(),
                               place.y(), place.z(), why));
}

/// Returns a value rounded to the digits that the program has. The next move starts from the
/// rounded value, so errors do not add up.
double Rounded(double value, double digits) { return std::round(value * digits) / digits; }

}  // namespace

double SafeHeight(const EngravePlan& plan, const ProgramOptions& options) {
  const AxisOptions& axes = options.axes;
  const bool turns = axes.layout == AxisLayout::kTableAb || axes.layout == AxisLayout::kTableBc;
  double highest = plan.map.mesh().points_mm[plan.map.mesh().triangles[0][0]].z(), farthest = 0;
  for (const auto& triangle : plan.map.mesh().triangles) {
    for (const int32_t vertex : triangle) {
      const Eigen::Vector3d& p = plan.map.mesh().points_mm[vertex];
      highest = std::max(highest, p.z());
      farthest = std::max(farthest, (p - axes.centre_mm).norm());
    }
  }
  const double top = turns ? std::max(highest, axes.centre_mm.z() + farthest) : highest;
  return top + (plan.options.engraved ? 0 : plan.texture.height_mm) + options.safe_mm;
}

std::string EngraveProgram::Start() {
  std::string text = "G21 G90 G17 G40 G49 G80\n";
  if (options_.tool == ToolKind::kExtruder) text += "M83\n";
  text += fmt::format("G0 Z{:.3f}\n", safe_z_mm_);
  if (options_.tool == ToolKind::kSpindle) text += fmt::format("M3 S{:g}\n", options_.power);
  return text;
}

std::string EngraveProgram::End() {
  std::string text;
  if (options_.axes.layout != AxisLayout::kNone)
    text += fmt::format("G0 {}0 {}0\n", axes_.Letters()[0], axes_.Letters()[1]);
  if (options_.tool == ToolKind::kSpindle) text += "M5\n";
  return text + "M2\n";
}

absl::StatusOr<EngraveProgram::AxisPose> EngraveProgram::PoseAt(const ToolPoint& point) const {
  const Eigen::Vector3d& n = point.normal;
  if (options_.axes.layout == AxisLayout::kNone) {
    const double steep = Atan2(Hypot(n.x(), n.y()), n.z()) * 180 / std::numbers::pi;
    if (steep > options_.steepest_deg)
      return OutOfReach(point.place_mm,
                        fmt::format("the surface is {:.1f} degrees steep, but a machine without "
                                    "rotary axes can work at most {:g} (steepest)",
                                    steep, options_.steepest_deg));
  }
  const auto angles = axes_.AnglesFor(n, at_.axes.angles_deg);
  if (!angles)
    return OutOfReach(point.place_mm,
                      fmt::format("the surface normal there is ({:.3f}, {:.3f}, {:.3f}), beyond "
                                  "the {:g} degrees that {} and {} may turn (tilt)",
                                  n.x(), n.y(), n.z(), options_.axes.tilt_deg, axes_.Letters()[0],
                                  axes_.Letters()[1]));
  return AxisPose{point.place_mm, {axes_.XyzFor(point.place_mm, *angles), *angles}};
}

void EngraveProgram::Switch(bool on, std::string* text) {
  if (on == on_ || options_.tool != ToolKind::kBeam) return;
  on_ = on;
  *text += on ? fmt::format("M3 S{:g}\n", options_.power) : "M5\n";
}

/// Moves from the safe height to a pose: first the axes turn, then the tool comes down.
void EngraveProgram::Approach(const AxisPose& pose, std::string* text) {
  const Eigen::Vector3d& p = pose.axes.xyz_mm;
  const auto out = std::back_inserter(*text);
  fmt::format_to(out, "G0 X{:.5f} Y{:.5f}", p.x(), p.y());
  for (const int i : {0, 1})
    if (options_.axes.layout != AxisLayout::kNone)
      fmt::format_to(out, " {}{:.6f}", axes_.Letters()[i], pose.axes.angles_deg[i]);
  fmt::format_to(out, "\nG0 Z{:.5f}\n", p.z());
  *text += options_.axes.layout == AxisLayout::kNone ? "G94\n" : "G93\n";
  at_ = pose;
}

void EngraveProgram::MoveTo(const AxisPose& pose, bool on, double spacing_mm, int depth,
                            std::string* text) {
  const AxisPose from = at_;
  const Eigen::Vector3d middle = (from.place_mm + pose.place_mm) / 2;
  const AxisValues half{(from.axes.xyz_mm + pose.axes.xyz_mm) / 2,
                        (from.axes.angles_deg + pose.axes.angles_deg) / 2};
  if (depth < kMostHalvings && (axes_.TipAt(half) - middle).norm() > options_.tolerance_mm) {
    MoveTo({middle, {axes_.XyzFor(middle, half.angles_deg), half.angles_deg}}, on, spacing_mm,
           depth + 1, text);
    MoveTo(pose, on, spacing_mm, depth + 1, text);
    return;
  }
  WriteMove(pose, on, spacing_mm, text);
}

void EngraveProgram::WriteMove(const AxisPose& pose, bool on, double spacing_mm,
                               std::string* text) {
  const auto out = std::back_inserter(*text);
  const double length = (pose.place_mm - at_.place_mm).norm();
  const Eigen::Vector2d turn = (pose.axes.angles_deg - at_.axes.angles_deg).cwiseAbs();
  const double feed = on ? options_.feed_mm_min : options_.link_mm_min;
  const double minutes =
      std::max({length / feed, turn.maxCoeff() / options_.turn_deg_min, kShortestSeconds / 60});
  const size_t start = text->size();
  *text += "G1";
  for (const int axis : {0, 1, 2})
    if (Rounded(pose.axes.xyz_mm[axis], 1e5) != Rounded(at_.axes.xyz_mm[axis], 1e5))
      fmt::format_to(out, " {}{:.5f}", "XYZ"[axis], pose.axes.xyz_mm[axis] + 0.0);
  for (const int i : {0, 1})
    if (Rounded(pose.axes.angles_deg[i], 1e6) != Rounded(at_.axes.angles_deg[i], 1e6))
      fmt::format_to(out, " {}{:.6f}", axes_.Letters()[i], pose.axes.angles_deg[i] + 0.0);
  if (text->size() == start + 2) {  // the next move adds the unwritten difference
    text->resize(start);
    return;
  }
  if (on && options_.tool == ToolKind::kExtruder) {
    const double section = std::numbers::pi * options_.filament_mm * options_.filament_mm / 4;
    const double filament = length * spacing_mm * options_.layer_mm / section + filament_rest_mm_;
    const double written = Rounded(filament, 1e5);
    filament_rest_mm_ = filament - written;
    facts_.filament_mm += written;
    fmt::format_to(out, " E{:.5f}", written);
  }
  if (options_.axes.layout == AxisLayout::kNone)
    fmt::format_to(out, " F{:g}\n", feed);
  else
    fmt::format_to(out, " F{:.4f}\n", 1 / minutes);
  facts_.seconds += 60 * minutes;
  ++facts_.moves;
  facts_.least_deg = facts_.least_deg.cwiseMin(pose.axes.angles_deg);
  facts_.most_deg = facts_.most_deg.cwiseMax(pose.axes.angles_deg);
  at_ = pose;
}

absl::StatusOr<std::string> EngraveProgram::Layer(const LayerPath& path) {
  at_ = {};
  filament_rest_mm_ = 0;
  std::string text = fmt::format("(layer {}, {:.4f} mm)\n", path.layer, path.offset_mm);
  for (size_t i = 0; i < path.points.size(); ++i) {
    const ToolPoint& point = path.points[i];
    const auto pose = PoseAt(point);
    if (!pose.ok()) return pose.status();
    if (i == 0) {
      Approach(*pose, &text);
      continue;
    }
    Switch(point.on, &text);
    MoveTo(*pose, point.on, path.spacing_mm, 0, &text);
  }
  Switch(false, &text);
  if (!path.points.empty()) text += fmt::format("G94\nG0 Z{:.3f}\n", safe_z_mm_);
  return text;
}

}  // namespace slicefarm::texture
