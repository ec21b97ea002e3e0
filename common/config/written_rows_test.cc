#include "common/config/written_rows.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/config/plate.h"
#include "common/model/limits.h"

namespace slicefarm::config::written_rows_test {
namespace {

/// Returns an object with height ranges that each have one setting, with different values.
SceneObject ObjectWith(int64_t ranges, const std::string& key) {
  SceneObject object;
  object.name = "box";
  object.parts.resize(1);
  object.instances.resize(1);
  for (int64_t i = 0; i < ranges; ++i)
    object.ranges.push_back({i * 0.5, i * 0.5 + 0.5, {{key, std::to_string(0.05 + i * 0.0001)}}});
  return object;
}

bool Fits(const std::vector<SceneObject>& objects) {
  return CheckWrittenRows(objects, Process::kFdm).ok();
}

TEST(CheckWrittenRows, CountsWhatRegionsMayHave) {
  // Heights outside of all ranges are a row as well.
  EXPECT_TRUE(Fits({ObjectWith(limits::kMaxRegionSettings - 1, "top_infill_extrusion_width")}));
  EXPECT_FALSE(Fits({ObjectWith(limits::kMaxRegionSettings, "top_infill_extrusion_width")}));
  EXPECT_TRUE(Fits({ObjectWith(5'000, "layer_height")})) << "of which no region has its own";
  const SceneObject many = ObjectWith(600, "top_infill_extrusion_width");
  EXPECT_TRUE(Fits({many, many, many}));
  EXPECT_FALSE(Fits({many, ObjectWith(600, "solid_infill_extrusion_width")}));
  SceneObject changed = many;
  changed.parts.resize(50);
  for (size_t i = 1; i < changed.parts.size(); ++i) {
    changed.parts[i].role = PartRole::kModifier;
    changed.parts[i].settings = {{"perimeters", std::to_string(i)}};
  }
  EXPECT_TRUE(Fits({changed})) << "modifiers";
  changed.parts[1].role = PartRole::kSolid;
  EXPECT_FALSE(Fits({changed}));
}

// Resolving a thousand sets takes a second, which is too much for a request that is then refused.
TEST(CheckWrittenRows, ARefusalResolvesNone) {
  const std::vector<SceneObject> objects = {
      ObjectWith(limits::kMaxRegionSettings, "top_infill_extrusion_width")};
  int resolved = 0;
  const CancelToken counting([&] {
    ++resolved;
    return false;
  });
  const absl::Status refused = ResolvePlate({}, objects, Process::kFdm, counting).status();
  EXPECT_EQ(DetailOf(refused).reason, Reason::kRequestTooLarge) << refused;
  EXPECT_EQ(resolved, 0);
}

}  // namespace
}  // namespace slicefarm::config::written_rows_test
