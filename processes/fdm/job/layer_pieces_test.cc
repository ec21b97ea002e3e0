#include "processes/fdm/job/layer_pieces.h"

#include <gtest/gtest.h>

namespace slicefarm::coordinator::layer_pieces_test {
namespace {

/// A layer that sets its fan, moves to its entry, and ends there.
struct Layer {
  std::string fan;
  std::string position;
  std::string code = {};  ///< inserted between the fan and the move
  std::string end = {};   ///< position of the nozzle at the end; empty: `position`
};

/// The joined text of the layers.
class Joined {
 public:
  Joined& Add(const Layer& layer) {
    LayerProgram program;
    program.gcode = ";layer\n" + layer.fan + "\n";
    program.mode_lines.push_back({7, std::ssize(layer.fan) + 1, MachineMode::kFan, layer.fan});
    program.code_at = {0, std::ssize(program.gcode)};
    const auto at = std::ssize(program.gcode);
    program.gcode += "G1 " + layer.position + "\n";
    program.mode_lines.push_back(
        {at, std::ssize(program.gcode) - at, MachineMode::kPosition, layer.position});
    program.gcode += "bead\n";
    program.modes_at_end =
        ModeValues{layer.fan, "", "", layer.end.empty() ? layer.position : layer.end, ""};
    std::vector<std::string> code = {"", layer.code};
    for (const LayerPiece& piece : join_.PiecesOf(program, std::ssize(program.gcode), code))
      text_ += program.gcode.substr(static_cast<size_t>(piece.first),
                                    static_cast<size_t>(piece.last - piece.first)) +
               piece.text;
    return *this;
  }
  Joined& Pass(const std::string& gcode) {
    join_.Pass(gcode);
    text_ += gcode;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  LayerJoin join_;
  std::string text_;
};

TEST(LayerJoin, WhatIsSetIsNotSetAgain) {
  EXPECT_EQ(Joined().Add({"M106 S9", "X1"}).Add({"M106 S9", "X1"}).Add({"M107", "X2"}).text(),
            ";layer\nM106 S9\nG1 X1\nbead\n;layer\nbead\n;layer\nM107\nG1 X2\nbead\n");
}

TEST(LayerJoin, TheNozzleIsWhereItsLayerLeftIt) {
  EXPECT_EQ(Joined().Add({"M107", "X1", "", "X5"}).Add({"M107", "X1"}).Add({"M107", "X1"}).text(),
            ";layer\nM107\nG1 X1\nbead\n;layer\nG1 X1\nbead\n;layer\nbead\n");
}

TEST(LayerJoin, AModeThatIsNotKnownAtTheEndIsSetAgain) {
  LayerProgram program;
  program.gcode = "M204 S500\nwall\nM204 S2000\ninfill\n";
  program.mode_lines = {{0, 10, MachineMode::kAcceleration, "M204 S500\n"}};
  program.modes_at_end = ModeValues{};
  LayerJoin join;
  for (int layer = 0; layer < 2; ++layer) {
    const std::vector<LayerPiece> pieces = join.PiecesOf(program, std::ssize(program.gcode), {});
    ASSERT_EQ(pieces.size(), 1u) << layer;
    EXPECT_EQ(pieces[0].first, 0) << layer;
  }
}

TEST(LayerJoin, OtherCodeMayChangeAnything) {
  const std::string whole = ";layer\nM107\nG1 X1\nbead\n";
  EXPECT_EQ(Joined().Add({"M107", "X1"}).Pass("G1 Z9\n").Add({"M107", "X1"}).text(),
            whole + "G1 Z9\n" + whole);
  EXPECT_EQ(Joined().Add({"M107", "X1"}).Pass("M73 P5\n").Add({"M107", "X1"}).text(),
            whole + "M73 P5\n;layer\nbead\n");
}

TEST(LayerJoin, CodeWithinALayerStaysInItsPlace) {
  EXPECT_EQ(Joined().Add({"M107", "X1"}).Add({"M107", "X1", "M117 hi\n"}).text(),
            ";layer\nM107\nG1 X1\nbead\n;layer\nM117 hi\nbead\n");
  EXPECT_EQ(Joined().Add({"M107", "X1"}).Add({"M107", "X1", "PARK\n"}).Add({"M107", "X1"}).text(),
            ";layer\nM107\nG1 X1\nbead\n;layer\nM107\nPARK\nG1 X1\nbead\n"
            ";layer\nM107\nG1 X1\nbead\n")
      << "nothing is known after it";
}

// The layer below ends retracted or ready; the layer above only changes the state if necessary.
TEST(LayerJoin, TheFilamentGoesBackAndForthWhereItIsNeeded) {
  LayerProgram meets;
  meets.mode_lines = {{3, 4, MachineMode::kFilament, std::string(kReady)}};
  LayerProgram goes_back = meets;
  goes_back.mode_lines[0].value = kRetracted;
  const std::vector<LayerPiece> whole = {{0, 9}}, without = {{0, 3}, {7, 9}};
  for (const bool retracted : {true, false}) {
    LayerProgram below;
    below.ends_retracted = retracted;
    for (const LayerProgram& above : {meets, goes_back}) {
      LayerJoin join;
      join.PiecesOf(below, 9, {});
      join.Pass("PARK\n");  // does not change the known state
      const bool needed = (above.mode_lines[0].value == kRetracted) != retracted;
      EXPECT_EQ(join.PiecesOf(above, 9, {}), needed ? whole : without);
    }
  }
}

TEST(LayerJoin, AProgramThatDoesNotKnowItsEndTellsAllAnew) {
  LayerJoin join;
  LayerProgram program;
  program.mode_lines = {{0, 2, MachineMode::kFan, "f"}};
  program.modes_at_end = ModeValues{"f", "", "", "", ""};
  const auto pieces = [&] { return join.PiecesOf(program, 5, {}); };
  EXPECT_EQ(pieces(), (std::vector<LayerPiece>{{0, 5}}));
  EXPECT_EQ(pieces(), (std::vector<LayerPiece>{{2, 5}}));
  program.modes_at_end.reset();
  EXPECT_EQ(pieces(), (std::vector<LayerPiece>{{0, 5}}));
  program.modes_at_end = ModeValues{"f", "", "", "", ""};
  EXPECT_EQ(pieces(), (std::vector<LayerPiece>{{0, 5}}));
}

}  // namespace
}  // namespace slicefarm::coordinator::layer_pieces_test
