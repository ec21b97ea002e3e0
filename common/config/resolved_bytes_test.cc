#include "common/config/resolved_bytes.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"
#include "common/config/plate.h"
#include "common/model/limits.h"
#include "common/model/options/infill_options.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::resolved_bytes_test {
namespace {

/// Returns the settings of a job with half a megabyte in each set, which all sets share.
std::vector<Setting> LongJob() { return {{"notes", std::string(500'000, 'x')}}; }

SceneObject ObjectWith(int ranges, int parts) {
  SceneObject object;
  object.name = "box";
  object.parts.resize(1);
  object.instances.resize(1);
  for (int i = 0; i < ranges; ++i)
    object.ranges.push_back({i * 0.5, i * 0.5 + 0.5, {{"perimeters", std::to_string(i % 97)}}});
  for (int i = 0; i < parts; ++i) {
    Part modifier;
    modifier.role = PartRole::kModifier;
    modifier.settings = {{"fill_density", std::to_string(i) + "%"}};
    object.parts.push_back(modifier);
  }
  return object;
}

Reason RefusalOf(const std::vector<Setting>& job, const std::vector<SceneObject>& objects) {
  return DetailOf(CheckResolvedBytes(job, objects)).reason;
}

TEST(CheckResolvedBytes, CountsEachDifferentSetOnce) {
  const auto fits = [](const std::vector<Setting>& job, const std::vector<SceneObject>& objects) {
    return CheckResolvedBytes(job, objects).ok();
  };
  EXPECT_TRUE(fits(LongJob(), {}));
  EXPECT_TRUE(fits(LongJob(), {ObjectWith(0, 0)}));
  EXPECT_TRUE(fits(LongJob(), std::vector(1'000, ObjectWith(20, 2)))) << "equal objects";
  EXPECT_TRUE(fits({{"notes", "short"}}, {ObjectWith(97, 90)}));
}

TEST(CheckResolvedBytes, RefusesWhatWouldTakeTooMuch) {
  EXPECT_EQ(RefusalOf(LongJob(), {ObjectWith(97, 90)}), Reason::kRequestTooLarge);
  const ErrorDetail detail =
      DetailOf(CheckResolvedBytes(LongJob(), std::vector{ObjectWith(97, 20)}));
  EXPECT_EQ(detail.metadata.at("limit"), std::to_string(limits::kMaxResolvedBytes));
  EXPECT_GT(std::stoll(detail.metadata.at("got")), limits::kMaxResolvedBytes);
  EXPECT_LT(std::stoll(detail.metadata.at("got")), limits::kMaxResolvedBytes + 1'000'000)
      << "it goes on counting";
}

// Modifiers make rows from the rows of other modifiers: two to the power of the number of
// modifiers.
TEST(CheckResolvedBytes, WhatModifiersMakeIsCountedWhenItIsMade) {
  const std::string field =
      R"({"kind":"constant",)" + std::string(400'000, ' ') + R"("density":0.3})";
  const std::vector<Setting> job;
  std::vector<SceneObject> objects = {ObjectWith(0, 8)};
  objects[0].settings = {{"density_field", field}};
  const char* keys[] = {"fill_density", "perimeters",      "fill_angle",   "top_solid_layers",
                        "infill_speed", "perimeter_speed", "bridge_speed", "bottom_solid_layers"};
  for (size_t i = 0; i < std::size(keys); ++i) objects[0].parts[i + 1].settings = {{keys[i], "7"}};
  ASSERT_TRUE(CheckResolvedBytes(job, objects).ok());
  EXPECT_EQ(DetailOf(ResolvePlate(job, objects, Process::kFdm).status()).reason,
            Reason::kRequestTooLarge);
}

// Each modifier has a row of its own, and all rows share the job's one field.
TEST(CheckResolvedBytes, ManyModifiersShareALongFieldOfTheJob) {
  const std::string field =
      R"({"kind":"constant",)" + std::string(700'000, ' ') + R"("density":0.3})";
  const std::vector<Setting> job = {{"density_field", field}};
  std::vector<SceneObject> objects = {ObjectWith(0, 90)};
  for (size_t i = 1; i < objects[0].parts.size(); ++i)
    objects[0].parts[i].settings = {{"perimeters", "7"}, {"infill_speed", std::to_string(10 + i)}};
  ASSERT_TRUE(CheckResolvedBytes(job, objects).ok());
  const auto plate = ResolvePlate(job, objects, Process::kFdm);
  ASSERT_TRUE(plate.ok()) << plate.status();
  const std::vector<InfillOptions> rows = InfillOf(FdmOf(plate->settings));
  ASSERT_GT(rows.size(), 90u);
  for (const InfillOptions& row : rows)
    EXPECT_EQ(&row.density_field.str(), &rows[0].density_field.str());
}

}  // namespace
}  // namespace slicefarm::config::resolved_bytes_test
