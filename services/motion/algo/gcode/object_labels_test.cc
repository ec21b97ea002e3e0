#include "services/motion/algo/gcode/object_labels.h"

#include <gtest/gtest.h>

#include "common/geometry/text_format_test.h"
#include "common/model/options/machine_limits.h"
#include "common/model/options/motion_options.h"

namespace slicefarm::motion::object_labels_test {
namespace {

MotionOptions Options(ObjectLabels labels, GcodeFlavor flavor = GcodeFlavor::kMarlin2) {
  MotionOptions options;
  options.labels = labels;
  options.flavor = flavor;
  return options;
}

const CopyName kSecond{"my part.stl", 4, 1, 3};

std::string Around(const MotionOptions& options) {
  GcodeText out;
  BeginCopy(kSecond, 7, options, out);
  out << "G1\n";
  EndCopy(kSecond, 7, options, out);
  return out.Take();
}

TEST(ObjectLabels, AsEachReaderWantsThem) {
  using enum ObjectLabels;
  EXPECT_EQ(Around(Options(kNone)), "G1\n");
  EXPECT_EQ(Around(Options(kComments)),
            "; printing object my part.stl id:4 copy 1\nG1\n"
            "; stop printing object my part.stl id:4 copy 1\n");
  EXPECT_EQ(Around(Options(kFirmware)), "M486 S7\nG1\nM486 S-1\n");
  EXPECT_EQ(Around(Options(kFirmware, GcodeFlavor::kKlipper)),
            "EXCLUDE_OBJECT_START NAME=my_part_stl_(Instance_2)-7\nG1\n"
            "EXCLUDE_OBJECT_END NAME=my_part_stl_(Instance_2)-7\n");
}

TEST(ObjectLabels, AreDefinedForFirmwares) {
  const std::vector<CopySummary> copies = {
      {{"a", 0, 0, 1}, MakePolygonsOrDie("(0 0, 10 0, 10 20)")[0].outer}, {{"b", 1, 0, 1}, {}}};
  GcodeText out;
  DefineCopies(copies, Options(ObjectLabels::kFirmware, GcodeFlavor::kKlipper), out);
  EXPECT_EQ(out.Take(),
            "EXCLUDE_OBJECT_DEFINE NAME=a-0 CENTER=5,10 POLYGON=[[0,0],[10,0],[10,20]]\n"
            "EXCLUDE_OBJECT_DEFINE NAME=b-1\n");
  DefineCopies(copies, Options(ObjectLabels::kFirmware), out);
  EXPECT_EQ(out.Take(), "M486 T2\nM486 S0\nM486 Aa\nM486 S-1\nM486 S1\nM486 Ab\nM486 S-1\n");
  DefineCopies(copies, Options(ObjectLabels::kComments), out);
  EXPECT_EQ(out.Take(), "");
}

// The user chooses the name, so it may contain anything.
TEST(ObjectLabels, NamesCannotBringCommandsAlong) {
  const CopyName bad{"x\nM112 ;'=\"{a}", 0, 0, 1};
  for (const GcodeFlavor flavor : {GcodeFlavor::kMarlin2, GcodeFlavor::kKlipper}) {
    for (const ObjectLabels labels : {ObjectLabels::kComments, ObjectLabels::kFirmware}) {
      const std::string label = LabelOf(bad, 0, Options(labels, flavor));
      EXPECT_EQ(label.find('\n'), std::string::npos);
      if (flavor == GcodeFlavor::kKlipper && labels == ObjectLabels::kFirmware) {
        EXPECT_EQ(label.find_first_of(" ;'\"={}"), std::string::npos) << label;
      }
    }
  }
}

}  // namespace
}  // namespace slicefarm::motion::object_labels_test
