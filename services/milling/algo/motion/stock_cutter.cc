#include "services/milling/algo/motion/stock_cutter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "services/milling/algo/motion/inside_area.h"
#include "services/milling/algo/strategy/plane.h"

namespace slicefarm::milling {
namespace {

/// Length in mm of the shortest pass along which the tip may ramp down.
constexpr double kLeastRampTravelMm = 0.5;
/// Distance of the positions at which a pass is tested for stock, as a fraction of the radius.
constexpr double kAskShare = 0.25;

ClosedPath ClosedPathOf(const Polygon& ring) {
  ClosedPath pass;
  for (const Point p : ring) pass.push_back(PointMmOf(p));
  return pass;
}

size_t NearestOf(const ClosedPath& pass, const Eigen::Vector2d& place) {
  size_t nearest = 0;
  for (size_t i = 1; i < pass.size(); ++i)
    if ((pass[i] - place).squaredNorm() < (pass[nearest] - place).squaredNorm()) nearest = i;
  return nearest;
}

double LengthOfPath(const ClosedPath& pass) {
  double length = 0;
  for (size_t i = 0; i < pass.size(); ++i) length += (pass[(i + 1) % pass.size()] - pass[i]).norm();
  return length;
}

}  // namespace

bool StockCutter::MeetsStock(const ClosedPath& pass, double z_mm) const {
  const double step = kAskShare * options_.cutter.radius_mm();
  double since = step;
  for (size_t i = 0; i < pass.size(); ++i) {
    const Eigen::Vector2d leg = pass[(i + 1) % pass.size()] - pass[i];
    const double length = leg.norm();
    for (double along = step - since; along < length; along += step) {
      const Eigen::Vector2d p = pass[i] + leg * (along / length);
      if (moves_.stock().Meets({p.x(), p.y(), z_mm}, moves_.stock().pixel_mm())) return true;
      since = -along;
    }
    since += length;
  }
  return false;
}

void StockCutter::RapidTo(const Eigen::Vector2d& place, double z_mm) {
  if (leave_) {
    moves_.ArcTo({leave_->to.x(), leave_->to.y(), moves_.at().z()}, leave_->centre,
                 leave_->clockwise, options_.machining.feed_mm_min);
    leave_.reset();
  }
  moves_.RapidTo(place, z_mm);
}

/// Moves straight to the start if the line stays in the area in which the tip is. Otherwise makes
/// no move and returns false.
bool StockCutter::LinkTo(const Eigen::Vector2d& start, double z_mm) {
  if (last_ == nullptr || moves_.at().z() < z_mm - 1e-3) return false;
  const Eigen::Vector2d at = moves_.at().head<2>();
  const bool same_level = last_ == area_;
  if (!same_level && (start - at).norm() > 2 * options_.cutter.radius_mm()) return false;
  if (!InsideArea(*last_, std::array{at, start})) return false;
  moves_.LineTo({start.x(), start.y(), moves_.at().z()}, options_.machining.feed_mm_min);
  leave_.reset();
  return true;
}

/// Moves to `start` from a pass outside of the stock: down beside the stock, then horizontally.
/// `air`: a pass that meets no stock. Makes no move and returns false if this is impossible.
bool StockCutter::EnterFromAir(const Eigen::Vector2d& start, const ClosedPath& air, double z_mm) {
  const Eigen::Vector2d& outside = air[NearestOf(air, start)];
  if (moves_.stock().Meets({outside.x(), outside.y(), z_mm}, moves_.stock().pixel_mm()))
    return false;
  if (!InsideArea(*area_, std::array{outside, start})) return false;
  RapidTo(outside, z_mm);
  moves_.LineTo({outside.x(), outside.y(), z_mm}, options_.machining.plunge_feed_mm_min);
  moves_.LineTo({start.x(), start.y(), z_mm}, options_.machining.feed_mm_min);
  return true;
}

bool StockCutter::LeadIn(const ClosedPath& pass, double z_mm) {
  const auto arcs =
      LeadArcsOf(pass, *area_, options_.machining.lead_in_radius_mm, options_.machining.direction);
  if (!arcs) return false;
  const Eigen::Vector3d from(arcs->from.x(), arcs->from.y(), z_mm);
  if (moves_.stock().Meets(from, moves_.stock().pixel_mm())) return false;
  RapidTo(arcs->from, z_mm);
  moves_.LineTo(from, options_.machining.plunge_feed_mm_min);
  moves_.ArcTo({pass[0].x(), pass[0].y(), z_mm}, arcs->centre, arcs->clockwise,
               options_.machining.feed_mm_min);
  leave_ = arcs;
  return true;
}

/// Lowers the tip from above a pass's start to the pass, through the stock between them. Returns
/// the pass, beginning at the tip's final position.
ClosedPath StockCutter::GoDown(const ClosedPath& pass, double z_mm, MillPhase phase) {
  const double plunge = options_.machining.plunge_feed_mm_min;
  const EntryKind entry = options_.machining.entry;
  const Eigen::Vector2d at = moves_.at().head<2>();
  const double pixel = moves_.stock().pixel_mm();
  // After LinkTo the tip may be below the pass by less than 1 um, so this is no clamp.
  const double rest = std::max(moves_.stock().RestHeight(at, pixel), z_mm);
  const double top = std::min(rest, moves_.at().z());
  moves_.LineTo({at.x(), at.y(), top}, plunge);
  if (top <= z_mm) return pass;
  if (entry == EntryKind::kHelix && phase == MillPhase::kRoughing &&
      HelixDown(pass, *area_, z_mm, options_, moves_))
    return pass;
  if (entry != EntryKind::kPlunge && LengthOfPath(pass) >= kLeastRampTravelMm)
    return RampDown(pass, z_mm, options_, moves_);
  moves_.LineTo({at.x(), at.y(), z_mm}, plunge);
  return pass;
}

ClosedPath StockCutter::Approach(ClosedPath pass, const ClosedPath* air, double z_mm,
                                 MillPhase phase) {
  const size_t nearest = moves_.placed() ? NearestOf(pass, moves_.at().head<2>()) : 0;
  std::rotate(pass.begin(), pass.begin() + static_cast<ptrdiff_t>(nearest), pass.end());
  if (LinkTo(pass[0], z_mm)) return GoDown(pass, z_mm, phase);
  if (phase == MillPhase::kRoughing) {
    if (air != nullptr && EnterFromAir(pass[0], *air, z_mm)) return pass;
  } else if (LeadIn(pass, z_mm)) {
    return pass;
  }
  RapidTo(pass[0], z_mm);
  return GoDown(pass, z_mm, phase);
}

int StockCutter::Cut(const CutArea& area, double z_mm, MillPhase phase) {
  area_ = &area.area;
  int cut = 0;
  std::optional<ClosedPath> air;
  for (const Polygon& ring : area.passes) {
    if (cancel_.Cancelled()) break;
    const ClosedPath pass = ClosedPathOf(ring);
    if (!MeetsStock(pass, z_mm)) {
      air = pass;
      continue;
    }
    ClosedPath started = Approach(pass, air ? &*air : nullptr, z_mm, phase);
    last_ = area_;
    started.push_back(started.front());
    moves_.FeedAlong(started, options_.machining.feed_mm_min);
    ++cut;
  }
  return cut;
}

}  // namespace slicefarm::milling
