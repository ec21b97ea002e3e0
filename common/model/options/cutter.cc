#include "common/model/options/cutter.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

#include "common/base/error.h"
#include "common/base/portable_math.h"

namespace slicefarm {
namespace {

absl::Status CutterError(std::string_view what, double got) {
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kSettingOutOfRange,
                   fmt::format("the cutter's {}, not {}", what, got),
                   {{"setting", "cutter"}, {"got", fmt::format("{}", got)}});
}

constexpr double kMaxDiameterMm = 1000;
constexpr double kLeastDiameterMm = 1e-3;

absl::Status CheckDiameter(double diameter_mm) {
  if (diameter_mm >= kLeastDiameterMm && diameter_mm <= kMaxDiameterMm) return absl::OkStatus();
  return CutterError("diameter must be from 0.001 to 1000 mm", diameter_mm);
}

absl::Status CheckAngle(double angle_deg) {
  if (angle_deg >= 0.01 && angle_deg <= 89.99) return absl::OkStatus();
  return CutterError("half angle must be from 0.01 to 89.99 degrees", angle_deg);
}

absl::Status CheckCorner(double corner_mm, double diameter_mm) {
  if (corner_mm > 0 && corner_mm <= diameter_mm / 2) return absl::OkStatus();
  return CutterError("corner radius must be above 0 and at most its radius", corner_mm);
}

absl::Status CheckGrowth(double tip_mm, double diameter_mm) {
  if (tip_mm < diameter_mm) return absl::OkStatus();
  return CutterError("tip must be narrower than its shaft", tip_mm);
}

double RadiansOf(double degrees) { return degrees * std::numbers::pi / 180; }

/// Returns a straight piece from (height, radius) to the height where the radius is `to_radius_mm`.
ProfilePiece Slope(double from_mm, double radius_mm, double slope, double to_radius_mm) {
  return {.from_mm = from_mm,
          .to_mm = from_mm + (to_radius_mm - radius_mm) / slope,
          .base_mm = radius_mm - slope * from_mm,
          .slope = slope};
}

ProfilePiece Shaft(double from_mm, double radius_mm) {
  return {.from_mm = from_mm, .base_mm = radius_mm};
}

}  // namespace

absl::StatusOr<Cutter> Cutter::Cylinder(double diameter_mm) {
  if (absl::Status status = CheckDiameter(diameter_mm); !status.ok()) return status;
  return Cutter(fmt::format("cyl:{}", diameter_mm), {Shaft(0, diameter_mm / 2)}, diameter_mm / 2);
}

absl::StatusOr<Cutter> Cutter::Ball(double diameter_mm) {
  absl::StatusOr<Cutter> ball = Bull(diameter_mm, diameter_mm / 2);
  if (ball.ok()) ball->name_ = fmt::format("ball:{}", diameter_mm);
  return ball;
}

absl::StatusOr<Cutter> Cutter::Bull(double diameter_mm, double corner_mm) {
  if (absl::Status status = CheckDiameter(diameter_mm); !status.ok()) return status;
  if (absl::Status status = CheckCorner(corner_mm, diameter_mm); !status.ok()) return status;
  const double radius = diameter_mm / 2;
  return Cutter(fmt::format("bull:{}:{}", diameter_mm, corner_mm),
                {{.to_mm = corner_mm, .corner_mm = corner_mm, .flat_mm = radius - corner_mm},
                 Shaft(corner_mm, radius)},
                radius);
}

absl::StatusOr<Cutter> Cutter::Cone(double diameter_mm, double angle_deg) {
  if (absl::Status status = CheckDiameter(diameter_mm); !status.ok()) return status;
  if (absl::Status status = CheckAngle(angle_deg); !status.ok()) return status;
  const ProfilePiece cone = Slope(0, 0, Tan(RadiansOf(angle_deg)), diameter_mm / 2);
  return Cutter(fmt::format("cone:{}:{}", diameter_mm, angle_deg),
                {cone, Shaft(cone.to_mm, diameter_mm / 2)}, diameter_mm / 2);
}

absl::StatusOr<Cutter> Cutter::BallCone(double tip_mm, double angle_deg, double diameter_mm) {
  absl::StatusOr<Cutter> cone = BullCone(tip_mm, tip_mm / 2, angle_deg, diameter_mm);
  if (cone.ok()) cone->name_ = fmt::format("ballcone:{}:{}:{}", tip_mm, angle_deg, diameter_mm);
  return cone;
}

absl::StatusOr<Cutter> Cutter::BullCone(double tip_mm, double corner_mm, double angle_deg,
                                        double diameter_mm) {
  for (const double diameter : {tip_mm, diameter_mm})
    if (absl::Status status = CheckDiameter(diameter); !status.ok()) return status;
  if (absl::Status status = CheckAngle(angle_deg); !status.ok()) return status;
  if (absl::Status status = CheckCorner(corner_mm, tip_mm); !status.ok()) return status;
  if (absl::Status status = CheckGrowth(tip_mm, diameter_mm); !status.ok()) return status;
  const double flat = tip_mm / 2 - corner_mm, angle = RadiansOf(angle_deg);
  const double height = corner_mm * (1 - Sin(angle)), width = flat + corner_mm * Cos(angle);
  const ProfilePiece cone = Slope(height, width, Tan(angle), diameter_mm / 2);
  return Cutter(fmt::format("bullcone:{}:{}:{}:{}", tip_mm, corner_mm, angle_deg, diameter_mm),
                {{.to_mm = height, .corner_mm = corner_mm, .flat_mm = flat},
                 cone,
                 Shaft(cone.to_mm, diameter_mm / 2)},
                diameter_mm / 2);
}

absl::StatusOr<Cutter> Cutter::ConeCone(double tip_mm, double tip_angle_deg, double angle_deg,
                                        double diameter_mm) {
  for (const double diameter : {tip_mm, diameter_mm})
    if (absl::Status status = CheckDiameter(diameter); !status.ok()) return status;
  for (const double angle : {tip_angle_deg, angle_deg})
    if (absl::Status status = CheckAngle(angle); !status.ok()) return status;
  if (absl::Status status = CheckGrowth(tip_mm, diameter_mm); !status.ok()) return status;
  if (angle_deg >= tip_angle_deg)
    return CutterError("upper cone must be steeper than the one at its tip", angle_deg);
  const ProfilePiece tip = Slope(0, 0, Tan(RadiansOf(tip_angle_deg)), tip_mm / 2);
  const ProfilePiece cone =
      Slope(tip.to_mm, tip_mm / 2, Tan(RadiansOf(angle_deg)), diameter_mm / 2);
  return Cutter(fmt::format("conecone:{}:{}:{}:{}", tip_mm, tip_angle_deg, angle_deg, diameter_mm),
                {tip, cone, Shaft(cone.to_mm, diameter_mm / 2)}, diameter_mm / 2);
}

double Cutter::Width(double height_mm) const {
  for (const ProfilePiece& piece : pieces_) {
    if (height_mm >= piece.to_mm) continue;
    if (piece.corner_mm > 0)
      return piece.flat_mm + std::sqrt(height_mm * (2 * piece.corner_mm - height_mm));
    return piece.base_mm + piece.slope * height_mm;
  }
  return radius_mm_;
}

double Cutter::TouchHeight(double rise, double run) const {
  for (const ProfilePiece& piece : pieces_) {
    if (piece.corner_mm > 0) {
      const double length = std::sqrt(rise * rise + run * run);
      // Equals corner (1 - run / length), without the difference of nearly equal numbers.
      const double height = piece.corner_mm * rise * rise / (length * (length + run));
      if (height <= piece.to_mm) return height;
    } else if (piece.slope * rise <= run) {
      return piece.from_mm;
    }
  }
  return full_height_mm();
}

double Cutter::HeightAt(double distance_mm) const {
  for (const ProfilePiece& piece : pieces_) {
    if (piece.corner_mm > 0) {
      const double out = std::max(0.0, distance_mm - piece.flat_mm);
      const double height =
          out * out /
          (piece.corner_mm +
           std::sqrt(std::max(0.0, piece.corner_mm * piece.corner_mm - out * out)));
      if (out <= piece.corner_mm && height <= piece.to_mm) return height;
    } else if (distance_mm <= piece.base_mm + piece.slope * piece.from_mm) {
      return piece.from_mm;
    } else if (piece.slope > 0) {
      const double height = (distance_mm - piece.base_mm) / piece.slope;
      if (height <= piece.to_mm) return height;
    }
  }
  return full_height_mm();
}

GrownCutter Cutter::Grown(double by_mm) const {
  const ProfilePiece& first = pieces_.front();
  const bool pointed = first.corner_mm <= 0 && first.base_mm <= 0;
  double tip = -by_mm;
  if (pointed && by_mm < 0)  // the cone's tip moves along the axis
    tip = -by_mm * std::sqrt(1 + first.slope * first.slope) / first.slope;
  std::vector<ProfilePiece> grown;
  if (first.corner_mm <= 0 && by_mm > 0) {  // a corner becomes round
    const double sine = first.slope / std::sqrt(1 + first.slope * first.slope);
    grown.push_back({.to_mm = by_mm * (1 - sine), .corner_mm = by_mm, .flat_mm = first.base_mm});
  }
  for (const ProfilePiece& piece : pieces_) {
    ProfilePiece next = piece;
    if (piece.corner_mm > 0) {
      next.corner_mm = piece.corner_mm + by_mm;
      if (next.corner_mm <= 0) continue;
      next.to_mm = piece.to_mm / piece.corner_mm * next.corner_mm;
    } else {
      next.base_mm += by_mm * std::sqrt(1 + piece.slope * piece.slope) + piece.slope * tip;
    }
    next.from_mm = 0;
    if (!grown.empty()) {
      ProfilePiece& last = grown.back();
      if (last.corner_mm <= 0)
        last.to_mm = (next.base_mm - last.base_mm) / (last.slope - next.slope);
      next.from_mm = last.to_mm;
    }
    grown.push_back(next);
  }
  return {Cutter("", std::move(grown), radius_mm_ + by_mm), tip};
}

}  // namespace slicefarm
