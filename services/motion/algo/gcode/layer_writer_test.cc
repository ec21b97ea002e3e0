#include "services/motion/algo/gcode/layer_writer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace slicefarm::motion::layer_writer_test {
namespace {

Move Print(int32_t x_um, Feature feature, float acceleration = 1000) {
  Move move;
  move.kind = MoveKind::kPrint;
  move.feature = feature;
  move.x_um = x_um;
  move.filament = 3'000;
  move.feed_rate = 1'800;
  move.width_um = 450;
  move.height_um = 200;
  move.acceleration_mm_s2 = acceleration;
  return move;
}

Move Travel(int32_t x_um, float acceleration = 3000) {
  Move move;
  move.x_um = x_um;
  move.feed_rate = 9'000;
  move.acceleration_mm_s2 = acceleration;
  return move;
}

std::string Written(const std::vector<Move>& moves, GcodeFlavor flavor = GcodeFlavor::kMarlin2,
                    const Accelerations& accelerations = {}, const LayerState& state = {}) {
  Toolpath path;
  path.moves = moves;
  GcodeText out;
  LayerWriter(FirmwareOf(flavor), accelerations, state).Write(path, 0, moves.size(), {}, out);
  return out.Take();
}

TEST(LayerWriter, TellsWhatChanges) {
  Move wide = Print(3'000, Feature::kPerimeter);
  wide.width_um = 600;
  Move wider = Print(4'000, Feature::kPerimeter);
  wider.width_um = 620;
  Move thick = Print(5'000, Feature::kPerimeter);
  thick.width_um = 620;
  thick.height_um = 300;
  EXPECT_EQ(Written({Print(1'000, Feature::kExternalPerimeter), Print(2'000, Feature::kPerimeter),
                     wide, wider, thick}),
            ";TYPE:External perimeter\n;WIDTH:0.45\n;HEIGHT:0.2\nG1 X1 Y0 E.03 F1800\n"
            ";TYPE:Perimeter\n;WIDTH:0.45\nG1 X2 E.03\n"
            ";WIDTH:0.6\nG1 X3 E.03\nG1 X4 E.03\n;HEIGHT:0.3\nG1 X5 E.03\n");
}

TEST(LayerWriter, WipesAreTold) {
  Move wipe = Print(2'000, Feature::kPerimeter);
  wipe.kind = MoveKind::kWipe;
  wipe.filament = -30'000;
  Move rest = wipe;
  rest.kind = MoveKind::kRetract;
  rest.filament = -1'000;
  EXPECT_EQ(Written({Travel(0), wipe, wipe, rest}),
            "G1 X0 Y0 F9000\n;WIPE_START\nG1 X2 E-.3 F1800\nG1 X2 Y0 E-.3\n;WIPE_END\nG1 E-.01\n");
  EXPECT_EQ(Written({Travel(0), wipe}, GcodeFlavor::kBambu),
            "G1 X0 Y0 F9000\n; WIPE_START\nG1 X2 E-.3 F1800\n; WIPE_END\n");
}

TEST(LayerWriter, MovesOfEachKind) {
  Move lift = Travel(0);
  lift.kind = MoveKind::kLift;
  lift.z_um = 700;
  Move retract = Travel(0);
  retract.kind = MoveKind::kRetract;
  retract.filament = -80'000;
  retract.feed_rate = 2'100;
  Move travel = Travel(-12'345);
  travel.z_um = 700;
  EXPECT_EQ(Written({retract, lift, travel}), "G1 E-.8 F2100\nG1 Z.7 F9000\nG1 X-12.345 Y0\n");
  travel.z_um = 900;
  EXPECT_EQ(Written({retract, lift, travel}), "G1 E-.8 F2100\nG1 Z.7 F9000\nG1 X-12.345 Y0 Z.9\n")
      << "it rises on its way";
}

TEST(LayerWriter, ACoordinateThatStaysIsNotSaid) {
  const auto to = [](int32_t x_um, int32_t y_um) {
    Move move = Travel(x_um);
    move.y_um = y_um;
    return move;
  };
  EXPECT_EQ(Written({to(1'000, 2'000), to(1'000, 3'000), to(2'000, 3'000), to(4'000, 5'000)}),
            "G1 X1 Y2 F9000\nG1 Y3\nG1 X2\nG1 X4 Y5\n");
  EXPECT_EQ(Written({to(1'000, 2'000), to(1'000, 2'000)}), "G1 X1 Y2 F9000\nG1 X1 Y2\n");
}

TEST(LayerWriter, AStretchGoesOnUntilItIsToldToForget) {
  Toolpath path;
  path.moves = {Travel(1'000), Travel(2'000), Travel(3'000)};
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), {}, {});
  writer.Write(path, 0, 1, {}, out);
  writer.Write(path, 1, 2, {}, out);
  writer.Forget();
  writer.Write(path, 2, 3, {}, out);
  EXPECT_EQ(out.text(), "G1 X1 Y0 F9000\nG1 X2 Y0\nG1 X3 Y0 F9000\n");
}

// The inserted text, a profile's layer_gcode, may have an M204 of its own.
TEST(LayerWriter, WhatOthersMayHaveSetIsSaidAnew) {
  Toolpath path;
  path.moves = {Print(1'000, Feature::kPerimeter), Travel(2'000),
                Print(3'000, Feature::kPerimeter)};
  Accelerations accelerations;
  accelerations.written = accelerations.travel_written = true;
  accelerations.travel = 3'000;
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), accelerations, {200});
  writer.Write(path, 0, 1, {}, out);
  writer.Forget();
  writer.Write(path, 1, 3, {}, out);
  EXPECT_EQ(out.text(),
            ";TYPE:Perimeter\n;WIDTH:0.45\nM204 P1000\nG1 X1 Y0 E.03 F1800\n"
            "M204 T3000\nG1 X2 Y0 F9000\nM204 P1000\nG1 X3 E.03 F1800\n");
}

TEST(LayerWriter, FanForBridges) {
  const std::string text =
      Written({Print(1'000, Feature::kPerimeter), Print(2'000, Feature::kBridgeInfill),
               Print(3'000, Feature::kOverhangPerimeter), Print(4'000, Feature::kPerimeter)},
              GcodeFlavor::kMarlin2, {}, {200, 35, 100});
  EXPECT_EQ(text,
            ";TYPE:Perimeter\n;WIDTH:0.45\nG1 X1 Y0 E.03 F1800\n"
            ";TYPE:Bridge infill\nM106 S255\n;WIDTH:0.45\nG1 X2 E.03\n"
            ";TYPE:Overhang perimeter\n;WIDTH:0.45\nG1 X3 E.03\n"
            ";TYPE:Perimeter\nM106 S89\n;WIDTH:0.45\nG1 X4 E.03\n");
}

TEST(LayerWriter, FanByFeatureAndRest) {
  const auto fans = [](const LayerState& state, Feature feature, uint8_t rest) {
    Move wall = Print(2'000, feature);
    wall.rest = rest;
    const std::string text =
        Written({Print(1'000, Feature::kInternalInfill), wall}, GcodeFlavor::kMarlin2, {}, state);
    const size_t at = text.find("M106 S");
    return at == std::string::npos ? 35.0 : std::round(std::stoi(text.substr(at + 6)) / 2.55);
  };
  const LayerState state{.height_um = 200, .fan_percent = 35, .bridge_fan_percent = 100};
  LayerState cools = state;
  cools.cooled_rest = 75;
  LayerState all = state;
  all.cooled_rest = kFullRest;
  LayerState interface = state;
  interface.line_fans = {
      .interface_percent = 60, .ironing_percent = 15, .internal_bridge_percent = 0};
  struct Case {
    const LayerState& state;
    Feature feature;
    uint8_t rest;
    double fan;
  };
  for (const Case& c : {Case{state, Feature::kExternalPerimeter, 0, 35},
                        {cools, Feature::kExternalPerimeter, 75, 100},
                        {cools, Feature::kPerimeter, 20, 100},
                        {cools, Feature::kPerimeter, 76, 35},
                        {cools, Feature::kSolidInfill, kFullRest, 35},
                        {all, Feature::kExternalPerimeter, kFullRest, 100},
                        {all, Feature::kPerimeter, kFullRest, 35},
                        {interface, Feature::kSupportInterface, kFullRest, 60},
                        {interface, Feature::kIroning, kFullRest, 15},
                        {interface, Feature::kSupport, kFullRest, 35}})
    EXPECT_EQ(fans(c.state, c.feature, c.rest), c.fan)
        << FeatureName(c.feature) << " " << int{c.rest};
}

TEST(LayerWriter, FanIsOnFromTheStartOfABridge) {
  EXPECT_NE(
      Written({Print(1'000, Feature::kBridgeInfill)}, GcodeFlavor::kMarlin2, {}, {200, 35, 100})
          .find("M106 S255"),
      std::string::npos);
}

TEST(LayerWriter, ABlockIsTheSameTextWhateverComesBefore) {
  Toolpath path;
  Move thick = Print(2'000, Feature::kBridgeInfill);
  thick.height_um = 300;
  path.moves = {Travel(500), Print(1'000, Feature::kPerimeter), thick};
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), {}, {200, 35, 100});
  std::vector<std::string> texts;
  for (int i = 0; i < 2; ++i) {
    writer.BeginBlock(out);
    writer.Write(path, 0, 3, {}, out);
    writer.EndBlock(out);
    texts.push_back(out.Take());
  }
  EXPECT_EQ(texts[0],
            "G1 X.5 Y0 F9000\n;TYPE:Perimeter\n;WIDTH:0.45\nG1 X1 E.03 F1800\n"
            ";TYPE:Bridge infill\nM106 S255\n;WIDTH:0.45\n;HEIGHT:0.3\nG1 X2 E.03\n"
            "M106 S89\n;HEIGHT:0.2\n");
  EXPECT_EQ(texts[1], texts[0]);
}

TEST(LayerWriter, AnAccelerationThatIsSetIsNotToldInTheNextBlock) {
  Toolpath path;
  path.moves = {Travel(500), Print(1'000, Feature::kPerimeter)};
  Accelerations accelerations;
  accelerations.written = true;
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), accelerations, {200});
  for (int i = 0; i < 2; ++i) {
    writer.BeginBlock(out);
    writer.Write(path, 0, 2, {}, out);
    writer.EndBlock(out);
  }
  EXPECT_EQ(out.text().find("M204"), out.text().rfind("M204"));
}

TEST(LayerWriter, AFanThatStaysIsNotTold) {
  Toolpath path;
  path.moves = {Print(1'000, Feature::kSupport)};
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), {}, {200, kFanAsBefore});
  writer.WriteLayerFan(out);
  writer.BeginBlock(out);
  writer.Write(path, 0, 1, {}, out);
  writer.EndBlock(out);
  EXPECT_EQ(out.text().find("M10"), std::string::npos) << out.text();
}

TEST(LayerWriter, ShiftsPlaces) {
  Toolpath path;
  path.moves = {Travel(500)};
  GcodeText out;
  LayerWriter(FirmwareOf(GcodeFlavor::kMarlin2), {}, {}).Write(path, 0, 1, {100'000, -2'500}, out);
  EXPECT_EQ(out.Take(), "G1 X100.5 Y-2.5 F9000\n");
}

std::string AccelerationsOnly(GcodeFlavor flavor, const Accelerations& accelerations) {
  const std::string text =
      Written({Travel(0), Print(1'000, Feature::kPerimeter), Travel(2'000),
               Print(3'000, Feature::kPerimeter), Print(4'000, Feature::kTopSolidInfill, 500)},
              flavor, accelerations);
  std::string lines;
  for (size_t at = text.find("M204"); at != std::string::npos; at = text.find("M204", at + 1)) {
    lines += text.substr(at, text.find('\n', at) - at) + ";";
  }
  return lines;
}

TEST(LayerWriter, ArcsWithTheSumOfTheirFilament) {
  Toolpath path;
  path.moves = {Travel(10'000), Print(9'000, Feature::kPerimeter),
                Print(5'000, Feature::kPerimeter), Print(0, Feature::kPerimeter),
                Print(-1'000, Feature::kPerimeter)};
  path.moves[3].y_um = 10'000;
  path.arcs = {{1, 4, {0, 0}, false}};
  GcodeText out;
  LayerWriter(FirmwareOf(GcodeFlavor::kMarlin2), {}, {})
      .Write(path, 0, path.moves.size(), {5'000, 0}, out);
  EXPECT_EQ(out.text(),
            "G1 X15 Y0 F9000\n;TYPE:Perimeter\n;WIDTH:0.45\n;HEIGHT:0.2\n"
            "G3 X5 Y10 I-10 J0 E.09 F1800\nG1 X4 Y0 E.03\n");
}

TEST(LayerWriter, AccelerationsByFlavour) {
  Accelerations unwritten;
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kMarlin2, unwritten), "");
  Accelerations accelerations;
  accelerations.written = true;
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kMarlin2, accelerations), "M204 P1000;M204 P500;");
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kKlipper, accelerations), "M204 S1000;M204 S500;");
  Accelerations travel = accelerations;
  travel.travel_written = true;
  travel.travel = 3000;
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kMarlin2, travel), "M204 T3000;M204 P1000;M204 P500;");
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kKlipper, travel),
            "M204 S3000;M204 S1000;M204 S3000;M204 S1000;M204 S500;");
  EXPECT_EQ(AccelerationsOnly(GcodeFlavor::kMarlinLegacy, travel),
            AccelerationsOnly(GcodeFlavor::kKlipper, travel));
}

std::vector<Move> WithJerk(std::vector<Move> moves, float travel_mm_s) {
  for (Move& move : moves)
    move.jerk_mm_s = move.kind == MoveKind::kTravel                ? travel_mm_s
                     : move.feature == Feature::kExternalPerimeter ? 7
                                                                   : 9;
  return moves;
}

TEST(LayerWriter, JerkWhereItChanges) {
  Accelerations accelerations;
  accelerations.jerks.written = true;
  const std::vector<Move> moves =
      WithJerk({Travel(0), Print(1'000, Feature::kPerimeter), Travel(2'000),
                Print(3'000, Feature::kPerimeter), Print(4'000, Feature::kExternalPerimeter)},
               9);
  const auto jerks = [&](const std::vector<Move>& some) {
    const std::string text = Written(some, GcodeFlavor::kMarlin2, accelerations);
    std::string lines;
    for (size_t at = text.find("M205"); at != std::string::npos; at = text.find("M205", at + 1))
      lines += text.substr(at, text.find('\n', at) - at) + ";";
    return lines;
  };
  EXPECT_EQ(jerks(moves), "M205 X9 Y9;M205 X7 Y7;");
  accelerations.jerks.travel = 12;
  EXPECT_EQ(jerks(WithJerk(moves, 12)),
            "M205 X12 Y12;M205 X9 Y9;M205 X12 Y12;M205 X9 Y9;M205 X7 Y7;");
  accelerations.jerks.written = false;
  EXPECT_EQ(jerks(moves), "");
}

TEST(LayerWriter, TheFirstJerkIsAMode) {
  Accelerations accelerations;
  accelerations.jerks.written = true;
  Toolpath path;
  path.moves = WithJerk({Print(1'000, Feature::kPerimeter), Print(2'000, Feature::kPerimeter)}, 9);
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kKlipper), accelerations, {});
  writer.Write(path, 0, 2, {}, out);
  const std::vector<ModeLine> lines = writer.TakeModeLines();
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].mode, MachineMode::kJerk);
  EXPECT_EQ(lines[0].value, "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=9\n");
  EXPECT_EQ(writer.Modes()[static_cast<size_t>(MachineMode::kJerk)], lines[0].value);
}

TEST(LayerWriter, AccelerationsOfShortMoves) {
  Accelerations accelerations;
  accelerations.written = true;
  accelerations.to_decel = 0.5;
  EXPECT_NE(Written({Print(1'000, Feature::kPerimeter)}, GcodeFlavor::kKlipper, accelerations)
                .find("SET_VELOCITY_LIMIT ACCEL=1000 ACCEL_TO_DECEL=500\n"),
            std::string::npos);
}

// A bead of 1 mm at 30 mm/s takes 33 ms.
TEST(LayerWriter, AFasterFanStartsEarly) {
  std::vector<Move> moves;
  for (int i = 1; i <= 5; ++i)
    moves.push_back(Print(i * 1'000, i == 5 ? Feature::kBridgeInfill : Feature::kPerimeter));
  LayerState state{.height_um = 200, .fan_percent = 35, .bridge_fan_percent = 100};
  const auto before_fan = [&](const char* fan) {
    const std::string text = Written(moves, GcodeFlavor::kMarlin2, {}, state);
    const size_t at = text.find(fan);
    EXPECT_NE(at, std::string::npos);
    EXPECT_EQ(text.find(fan, at + 1), std::string::npos);
    return text.substr(0, at);
  };
  EXPECT_NE(before_fan("M106 S255").find("X4"), std::string::npos);
  state.fan_early_s = 0.07;
  const std::string early = before_fan("M106 S255");
  EXPECT_NE(early.find("X2"), std::string::npos);
  EXPECT_EQ(early.find("X3"), std::string::npos);
}

TEST(LayerWriter, OtherFansStartEarlyIfAllDo) {
  LayerState state{.height_um = 200, .fan_percent = 0, .bridge_fan_percent = 100};
  state.line_fans.interface_percent = 60;
  state.fan_early_s = 10;
  const std::vector<Move> moves = {Print(1'000, Feature::kSupport),
                                   Print(2'000, Feature::kSupportInterface)};
  EXPECT_GT(Written(moves, GcodeFlavor::kMarlin2, {}, state).find("M106 S153"),
            Written(moves, GcodeFlavor::kMarlin2, {}, state).find("X1"));
  state.fan_early_all = true;
  EXPECT_LT(Written(moves, GcodeFlavor::kMarlin2, {}, state).find("M106 S153"),
            Written(moves, GcodeFlavor::kMarlin2, {}, state).find("X1"));
}

TEST(LayerWriter, ARunningFanHasItsLeastSpeed) {
  LayerState state{.height_um = 200, .fan_percent = 0, .bridge_fan_percent = 20};
  state.fan_limits.least_percent = 40;
  const std::string text =
      Written({Print(1'000, Feature::kBridgeInfill), Print(2'000, Feature::kPerimeter)},
              GcodeFlavor::kMarlin2, {}, state);
  EXPECT_NE(text.find("M106 S102\n"), text.npos);
  EXPECT_NE(text.find("M107\n"), text.npos) << "off stays off";
}

TEST(LayerWriter, KickstartEndsWithTheBlock) {
  Toolpath path;
  path.moves = {Print(1'000, Feature::kPerimeter)};
  LayerState state{.height_um = 200, .fan_percent = 30};
  state.fan_limits.kickstart_s = 100;
  state.fan_is_off = true;
  GcodeText out;
  LayerWriter writer(FirmwareOf(GcodeFlavor::kMarlin2), {}, state);
  writer.WriteLayerFan(out);
  EXPECT_EQ(out.text(), "M106 S255\n");
  writer.BeginBlock(out);
  writer.Write(path, 0, 1, {}, out);
  writer.EndBlock(out);
  EXPECT_NE(out.text().find("M106 S77\n"), std::string::npos);
}

TEST(LayerWriter, WritesGcodeBetweenFeatures) {
  RoleTexts roles;
  const auto role = [](Feature feature) { return static_cast<int32_t>(feature); };
  roles[{-1, role(Feature::kPerimeter)}] = "M1";
  roles[{role(Feature::kPerimeter), role(Feature::kIroning)}] = "M2";
  LayerState state{.height_um = 200};
  state.roles = &roles;
  const std::string text =
      Written({Print(1'000, Feature::kPerimeter), Print(2'000, Feature::kPerimeter),
               Print(3'000, Feature::kIroning)},
              GcodeFlavor::kMarlin2, {}, state);
  EXPECT_EQ(text.find("M1\n;TYPE:Perimeter"), 0u);
  EXPECT_NE(text.find("M2\n;TYPE:Ironing"), text.npos);
  EXPECT_NE(text.find("G1 X3 Y0 E.03 F1800"), text.npos) << "position and speed are set again";
}

}  // namespace
}  // namespace slicefarm::motion::layer_writer_test
