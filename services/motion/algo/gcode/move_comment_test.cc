#include "services/motion/algo/gcode/move_comment.h"

#include <gtest/gtest.h>

#include <vector>

namespace slicefarm::motion::move_comment_test {
namespace {

Move Of(MoveKind kind, int32_t z_um = 200, Feature feature = Feature::kPerimeter) {
  Move move;
  move.kind = kind;
  move.z_um = z_um;
  move.feature = feature;
  return move;
}

TEST(CommentOn, IsWhatPrusaSlicerSays) {
  Toolpath path;
  path.start_z_um = 200;
  path.moves = {Of(MoveKind::kLift, 600),
                Of(MoveKind::kTravel, 600),
                Of(MoveKind::kLift, 400),
                Of(MoveKind::kRestart, 400),
                Of(MoveKind::kPrint, 400, Feature::kExternalPerimeter),
                Of(MoveKind::kRetract, 400),
                Of(MoveKind::kWipe, 400),
                Of(MoveKind::kTravel, 400),
                Of(MoveKind::kPrint, 400, Feature::kInternalInfill),
                Of(MoveKind::kTravel, 400)};
  const std::vector<std::string_view> want = {"lift Z",           "move to first perimeter point",
                                              "restore layer Z",  "unretract",
                                              "perimeter",        "retract",
                                              "wipe and retract", "move to first infill point",
                                              "infill",           "move on"};
  for (size_t i = 0; i < want.size(); ++i) EXPECT_EQ(CommentOn(path, i), want[i]) << i;
}

TEST(CommentOn, NamesEveryFeature) {
  for (int feature = 0; feature < kFeatureCount; ++feature) {
    Toolpath path;
    path.moves = {Of(MoveKind::kTravel, 0, static_cast<Feature>(feature)),
                  Of(MoveKind::kPrint, 0, static_cast<Feature>(feature))};
    EXPECT_FALSE(CommentOn(path, 1).empty()) << feature;
    EXPECT_EQ(CommentOn(path, 0), "move to first " + std::string(CommentOn(path, 1)) + " point");
  }
}

}  // namespace
}  // namespace slicefarm::motion::move_comment_test
