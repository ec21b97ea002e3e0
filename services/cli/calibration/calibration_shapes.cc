#include "services/cli/calibration/calibration_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/base/portable_math.h"

namespace slicefarm::cli {
namespace {

constexpr float kTextDepth = 0.6F;
constexpr float kTextShare = 0.62F;  ///< height of a label as a share of its floor

using Outline = std::vector<std::array<float, 2>>;

/// Adds the labels to a wall with its left edge at x, each in the middle of its floor.
void AddLabels(const Floors& floors, float x, float y, SolidBuilder& solid) {
  const auto floor = static_cast<float>(floors.floor_mm);
  const float height = floor * kTextShare;
  for (size_t i = 0; i < floors.labels.size(); ++i) {
    const float z = static_cast<float>(floors.Bottom(i)) + (floor - height) / 2;
    solid.AddTextOnFront(floors.labels[i], {x, y, z}, height, kTextDepth);
  }
}

/// Returns the width of the widest label.
float LabelWidth(const Floors& floors) {
  float width = 0;
  for (const std::string& label : floors.labels)
    width = std::max(width, TextWidth(label, static_cast<float>(floors.floor_mm) * kTextShare));
  return width;
}

float TowerTop(const Floors& floors) {
  return static_cast<float>(floors.Bottom(floors.labels.size()));
}

float BaseTop(const Floors& floors) { return static_cast<float>(floors.base_mm); }

/// Returns a tower with a convex outline and labels on its front, from x = `label_x` on.
std::string Tower(const Floors& floors, const Outline& outline, float label_x) {
  SolidBuilder solid;
  solid.AddPrism(outline, 2, 0, TowerTop(floors));
  AddLabels(floors, label_x, 0, solid);
  return solid.Stl();
}

}  // namespace

Floors FloorsOf(double floor_mm, double first_layer_mm, double layer_mm,
                std::vector<std::string> labels) {
  constexpr double kBaseMm = 1;
  const auto layers = [&](double height_mm) {
    return std::max(1.0, std::round(height_mm / layer_mm)) * layer_mm;
  };
  return {first_layer_mm + layers(kBaseMm - first_layer_mm), layers(floor_mm), std::move(labels)};
}

std::string TemperatureTower(const Floors& floors) {
  constexpr float kDepth = 10, kGap = 30, kPillar = 10, kBridge = 1.2F, kReach = 6;
  const float left = LabelWidth(floors) + 3, right = left + kGap, end = right + kPillar;
  const auto floor = static_cast<float>(floors.floor_mm);
  SolidBuilder solid;
  solid.AddBox({-kReach - 2, -2, 0}, {end + kReach + 2, kDepth + 2, BaseTop(floors)});
  solid.AddBox({0, 0, 0}, {left, kDepth, TowerTop(floors)});
  solid.AddBox({right, 0, 0}, {end, kDepth, TowerTop(floors)});
  for (size_t i = 0; i < floors.labels.size(); ++i) {
    const auto z = static_cast<float>(floors.Bottom(i));
    solid.AddBox({left - 1, 0, z + floor - kBridge}, {right + 1, kDepth, z + floor});
    // Overhangs of 45 degrees at the left, and of 30 degrees above the bed at the right.
    const float low = z + 0.2F * floor, high = std::min(low + kReach, z + floor);
    solid.AddPrism({{1, low}, {1, high}, {low - high, high}, {0, low}}, 1, 1, kDepth - 1);
    const float flat = low + kReach * 0.577F;
    solid.AddPrism({{end - 1, low}, {end, low}, {end + kReach, flat}, {end - 1, flat}}, 1, 1,
                   kDepth - 1);
  }
  AddLabels(floors, 1.5F, 0, solid);
  return solid.Stl();
}

std::string PillarPair(const Floors& floors) {
  constexpr float kSide = 12, kDistance = 60;
  const float left = std::max(kSide, LabelWidth(floors) + 2);
  SolidBuilder solid;
  solid.AddBox({-2, -2, 0}, {left + kDistance + kSide + 2, kSide + 2, BaseTop(floors)});
  solid.AddBox({0, 0, 0}, {left, kSide, TowerTop(floors)});
  solid.AddBox({left + kDistance, 0, 0}, {left + kDistance + kSide, kSide, TowerTop(floors)});
  AddLabels(floors, 1, 0, solid);
  return solid.Stl();
}

std::string CornerTower(const Floors& floors) {
  constexpr float kWide = 60, kDeep = 40, kArm = 25;
  SolidBuilder solid;
  solid.AddBox({0, 0, 0}, {kWide, kArm, TowerTop(floors)});
  solid.AddBox({0, 0, 0}, {kArm, kDeep, TowerTop(floors)});
  AddLabels(floors, (kWide - LabelWidth(floors)) / 2, 0, solid);
  return solid.Stl();
}

std::string FlatWallTower(const Floors& floors) {
  constexpr float kSide = 60, kCut = 17.5F;
  return Tower(floors,
               {{kCut, 0},
                {kSide - kCut, 0},
                {kSide, kCut},
                {kSide, kSide - kCut},
                {kSide - kCut, kSide},
                {kCut, kSide},
                {0, kSide - kCut},
                {0, kCut}},
               (kSide - LabelWidth(floors)) / 2);
}

std::string LongTower(const Floors& floors) {
  constexpr float kLength = 100, kRadius = 10;
  constexpr int kCorners = 24;  // of each half circle
  Outline outline;
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = (static_cast<double>(i) / kCorners - 0.5) * std::numbers::pi;
    outline.push_back({kLength + static_cast<float>(kRadius * Cos(angle)),
                       kRadius + static_cast<float>(kRadius * Sin(angle))});
  }
  for (int i = 0; i <= kCorners; ++i) {
    const double angle = (static_cast<double>(i) / kCorners + 0.5) * std::numbers::pi;
    outline.push_back({static_cast<float>(kRadius * Cos(angle)),
                       kRadius + static_cast<float>(kRadius * Sin(angle))});
  }
  return Tower(floors, outline, (kLength - LabelWidth(floors)) / 2);
}

std::string FlowPlate(const std::string& label) {
  constexpr float kSide = 30, kHeight = 2, kText = 6, kTab = 1, kMargin = 1.5F;
  SolidBuilder solid;
  solid.AddBox({0, 0, 0}, {kSide, kSide, kHeight});
  solid.AddBox({kSide - 1, 0, 0},
               {kSide + TextWidth(label, kText) + 2 * kMargin, kText + 2 * kMargin, kTab});
  solid.AddTextOnTop(label, {kSide + kMargin, kMargin, kTab}, kText, kTextDepth);
  return solid.Stl();
}

}  // namespace slicefarm::cli
