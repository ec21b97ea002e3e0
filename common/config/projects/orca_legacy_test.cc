#include "common/config/projects/orca_legacy.h"

#include <gtest/gtest.h>

namespace slicefarm::config::orca_legacy_test {
namespace {

struct Case {
  Setting from, to;
};

TEST(Modernized, RenamesKeysAndValues) {
  for (const Case& c :
       {Case{{"wall_infill_order", "outer wall/inner wall/infill"},
             {"wall_sequence", "outer wall/inner wall"}},
        Case{{"wall_infill_order", "inner-outer-inner wall/infill"},
             {"wall_sequence", "inner-outer-inner wall"}},
        Case{{"chamber_temperatures", R"(["60"])"}, {"chamber_temperature", R"(["60"])"}},
        Case{{"support_type", "tree"}, {"support_type", "tree(manual)"}},
        Case{{"ensure_vertical_shell_thickness", "1"},
             {"ensure_vertical_shell_thickness", "ensure_all"}},
        Case{{"support_type", "tree(auto)"}, {"support_type", "tree(auto)"}},
        Case{{"layer_height", "0.2"}, {"layer_height", "0.2"}}})
    EXPECT_EQ(Modernized(c.from), c.to) << c.from.key;
}

TEST(Modernized, KeepsTheSource) {
  EXPECT_EQ(Modernized({"thumbnail_size", "9x9", Source::kProfile}).source, Source::kProfile);
}

}  // namespace
}  // namespace slicefarm::config::orca_legacy_test
