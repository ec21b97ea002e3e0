#include "common/config/plate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/config/setting_pairs_test.h"
#include "common/model/limits.h"
#include "processes/fdm/model/fdm_settings.h"

namespace slicefarm::config::plate_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::Pair;
using testing::SizeIs;
using testing::UnorderedElementsAre;

SceneObject ObjectNamed(const std::string& name, const Pairs& own = {}, int32_t copies = 1) {
  SceneObject object = ObjectOfFile(name, 0, {}, copies);
  object.settings = Settings(own);
  return object;
}

Part PartOf(int32_t file, PartRole role, const Pairs& own) {
  Part part;
  part.mesh.file = file;
  part.role = role;
  part.settings = Settings(own);
  return part;
}

Instance StandingAt(double x_mm, double y_mm, double turn_deg = 0) {
  Instance instance;
  Placement placement;
  placement.rotate_deg = {0, 0, turn_deg};
  instance.to_plate = TransformOf(placement);
  instance.to_plate(0, 3) = x_mm;
  instance.to_plate(1, 3) = y_mm;
  return instance;
}

ResolvedPlate PlateOrDie(const Pairs& job, const std::vector<SceneObject>& objects) {
  auto plate = ResolvePlate(Settings(job), objects, Process::kFdm);
  if (!plate.ok()) {
    ADD_FAILURE() << plate.status();
    return {};
  }
  return *std::move(plate);
}

absl::Status PlateRefusal(const Pairs& job, const std::vector<SceneObject>& objects) {
  return ResolvePlate(Settings(job), objects, Process::kFdm).status();
}

TEST(ResolvePlate, PartsAreLargerByWhatTheirFilamentShrinks) {
  SceneObject object = ObjectNamed("part");
  object.instances = {StandingAt(20, 30)};
  object.instances[0].to_plate(2, 3) = 5;
  const Pairs shrinking = {{"filament_shrinkage_compensation_xy", "1%,5%"},
                           {"filament_shrinkage_compensation_z", "-10"}};
  const ResolvedPlate grown = PlateOrDie(shrinking, {object});
  const Transform& to_plate = grown.objects[0].to_plate;
  EXPECT_DOUBLE_EQ(to_plate(0, 0), 100. / 99);
  EXPECT_DOUBLE_EQ(to_plate(1, 1), 100. / 99);
  EXPECT_DOUBLE_EQ(to_plate(2, 2), 100. / 110);
  EXPECT_DOUBLE_EQ(to_plate(2, 3), 500. / 110);
  EXPECT_EQ(grown.objects[0].copies, PlateOrDie({}, {object}).objects[0].copies) << "moved";
  EXPECT_THAT(grown.effective_text, HasSubstr("filament_shrinkage_compensation_xy = 1%"));

  // The factor is the factor of the tool in use, also for a rotated object.
  object.settings = Settings({{"extruder", "2"}});
  object.instances = {StandingAt(20, 30, 90)};
  const ResolvedPlate second = PlateOrDie(shrinking, {object});
  EXPECT_NEAR(second.objects[0].to_plate(0, 1), -100. / 95, 1e-12);

  EXPECT_EQ(DetailOf(PlateRefusal({{"filament_shrinkage_compensation_z", "50%"}}, {object})).reason,
            Reason::kSettingOutOfRange);
}

double Density(const ResolvedPlate& plate, int32_t row) {
  return FdmOf(plate.settings).regions[static_cast<size_t>(row)].infill.density;
}

TEST(ResolvePlate, WarnsOnceOfWhatObjectsAskFor) {
  SceneObject a = ObjectOfFile("a", 0, {}, 1), b = ObjectOfFile("b", 1, {}, 1);
  a.settings = b.settings = {{"colorprint_heights", "5", Source::kProfile}};
  EXPECT_THAT(PlateOrDie({}, {a, b}).warnings,
              testing::ElementsAre(testing::StartsWith("a: colorprint_heights = 5")));
  const std::vector<Setting> job = {{"colorprint_heights", "5", Source::kProfile}};
  const auto plate = ResolvePlate(job, std::vector<SceneObject>{a, b}, Process::kFdm);
  ASSERT_TRUE(plate.ok()) << plate.status();
  EXPECT_THAT(plate->warnings, testing::ElementsAre(testing::StartsWith("colorprint_heights = 5")));
}

TEST(ResolvePlate, ArrangedCopiesLeaveRoomForTheWidestBrim) {
  const auto clearance = [](const Pairs& job, const char* brim_of_b) {
    SceneObject a = ObjectOfFile("a", 0, {}, 1), b = ObjectOfFile("b", 1, {}, 1);
    b.settings = {{"brim_width", brim_of_b, Source::kProfile}};
    return PlateOrDie(job, {a, b}).settings.slicing.clearance_radius_nm;
  };
  EXPECT_EQ(clearance({}, "0"), 0);
  EXPECT_EQ(clearance({{"brim_width", "3"}}, "0"), FromMm(6 + 2 * 3));
  EXPECT_EQ(clearance({{"brim_width", "3"}, {"brim_separation", "0.5"}}, "8"), FromMm(6 + 2 * 8.5));
  EXPECT_EQ(clearance({{"brim_type", "inner_only"}}, "8"), 0);
  EXPECT_EQ(clearance({{"complete_objects", "1"}, {"extruder_clearance_radius", "45"}}, "8"),
            FromMm(45));
}

TEST(ResolvePlate, ANeedThatAnObjectMeetsIsMet) {
  const std::vector<Setting> job = {{"raft_expansion", "4"}};
  SceneObject plain = ObjectOfFile("a", 0, {}, 1);
  SceneObject raft = ObjectOfFile("b", 1, {}, 1);
  raft.settings = {{"raft_layers", "2"}};
  const std::vector<SceneObject> without = {plain}, with = {plain, raft};
  EXPECT_EQ(ResolvePlate(job, without, Process::kFdm)->no_effect.size(), 1u);
  EXPECT_TRUE(ResolvePlate(job, with, Process::kFdm)->no_effect.empty());
  // An object that overrides the value does not use the value of the job.
  raft.settings.push_back({"raft_expansion", "5"});
  const std::vector<SceneObject> replaced = {plain, raft};
  EXPECT_EQ(ResolvePlate(job, replaced, Process::kFdm)->no_effect.size(), 1u);
}

TEST(ResolvePlate, TellsOfEnforcersWithoutSupports) {
  SceneObject object = ObjectNamed("cup");
  object.parts.push_back(PartOf(1, PartRole::kSupportEnforcer, {}));
  object.parts.push_back(PartOf(2, PartRole::kSupportBlocker, {}));
  const std::string note =
      "cup: support enforcers, painted or as parts: needs support_material = 1";
  const ResolvedPlate without = PlateOrDie({}, {object});
  EXPECT_THAT(TextsOf(without.no_effect), ElementsAre(note));
  EXPECT_THAT(without.warnings, ElementsAre(note));
  EXPECT_THAT(PlateOrDie({{"support_material", "1"}}, {object}).warnings, IsEmpty());
  object.settings = Settings({{"support_material", "1"}});
  EXPECT_THAT(PlateOrDie({}, {object}).warnings, IsEmpty()) << "the object has supports";
  object.settings = {};
  object.parts.erase(object.parts.begin() + 1);
  EXPECT_THAT(PlateOrDie({}, {object}).warnings, IsEmpty()) << "what is blocked is not there";
}

TEST(ResolvePlate, TellsOfHeightsThatAProfileTakesThePlaceOf) {
  SceneObject object = ObjectNamed("cup");
  object.ranges = {{1, 2, Settings({{"layer_height", "0.1"}, {"perimeters", "4"}})}};
  EXPECT_THAT(TextsOf(PlateOrDie({}, {object}).no_effect), IsEmpty());
  object.settings = Settings({{"layer_height_profile", "0;0.2;10;0.2"}});
  EXPECT_THAT(TextsOf(PlateOrDie({}, {object}).no_effect),
              ElementsAre("cup: layer_height = 0.1 from 1 to 2 mm: needs no layer_height_profile, "
                          "which replaces it"));
}

TEST(ResolvePlate, OneObjectWithoutSettingsOfItsOwn) {
  const ResolvedPlate plate = PlateOrDie({{"fill_density", "30%"}}, {ObjectNamed("box")});
  ASSERT_THAT(plate.objects, SizeIs(1));
  EXPECT_EQ(plate.objects[0].name, "box");
  EXPECT_THAT(plate.objects[0].parts[0].regions, ElementsAre(0));
  ASSERT_THAT(FdmOf(plate.settings).regions, SizeIs(1));
  EXPECT_DOUBLE_EQ(Density(plate, 0), 0.3);
  EXPECT_THAT(plate.settings.slicing.objects, SizeIs(1));
  EXPECT_THAT(plate.effective_text, Not(HasSubstr("object_settings")));
}

TEST(ResolvePlate, TheNarrowerPlaceWins) {
  SceneObject object = ObjectNamed("box", {{"fill_density", "20%"}});
  object.parts.push_back(PartOf(1, PartRole::kSolid, {{"fill_density", "40%"}}));
  object.ranges.push_back({5, 10, Settings({{"fill_density", "80%"}})});
  const ResolvedPlate plate = PlateOrDie({{"fill_density", "10%"}}, {object});
  const std::vector<PartInput>& parts = plate.objects[0].parts;
  ASSERT_THAT(parts, SizeIs(2));
  ASSERT_THAT(parts[0].regions, SizeIs(2));
  EXPECT_DOUBLE_EQ(Density(plate, parts[0].regions[0]), 0.8);  // in the range
  EXPECT_DOUBLE_EQ(Density(plate, parts[0].regions[1]), 0.2);
  EXPECT_DOUBLE_EQ(Density(plate, parts[1].regions[0]), 0.8);
  EXPECT_DOUBLE_EQ(Density(plate, parts[1].regions[1]), 0.4);
  EXPECT_EQ(parts[0].regions[0], parts[1].regions[0]);  // alike: one row
}

TEST(ResolvePlate, AModifierChangesWhatItLiesIn) {
  SceneObject object = ObjectNamed("box");
  object.parts.push_back(PartOf(1, PartRole::kModifier, {{"fill_density", "60%"}}));
  object.parts.push_back(PartOf(2, PartRole::kModifier, {{"perimeters", "5"}}));
  const ResolvedPlate plate = PlateOrDie({{"fill_density", "10%"}, {"perimeters", "2"}}, {object});
  const std::vector<PartInput>& parts = plate.objects[0].parts;
  const int32_t part = parts[0].regions[0];
  const int32_t dense = parts[1].changes.at(part);
  const int32_t thick = parts[2].changes.at(part);
  const int32_t both = parts[2].changes.at(dense);
  EXPECT_DOUBLE_EQ(Density(plate, dense), 0.6);
  EXPECT_DOUBLE_EQ(Density(plate, thick), 0.1);
  EXPECT_DOUBLE_EQ(Density(plate, both), 0.6);
  const auto walls = [&](int32_t row) {
    return FdmOf(plate.settings).regions[static_cast<size_t>(row)].walls.perimeters;
  };
  EXPECT_EQ(walls(part), 2);
  EXPECT_EQ(walls(dense), 2);
  EXPECT_EQ(walls(thick), 5);
  EXPECT_EQ(walls(both), 5);
}

TEST(ResolvePlate, ARangeHasALayerHeightOfItsOwn) {
  SceneObject object = ObjectNamed("tower");
  object.ranges.push_back({5, 10, Settings({{"layer_height", "0.1"}})});
  const ResolvedPlate plate = PlateOrDie({{"layer_height", "0.3"}}, {object});
  EXPECT_THAT(plate.objects[0].ranges, ElementsAre(RangeInput{5'000'000, 10'000'000, 100'000}));
  EXPECT_EQ(plate.settings.slicing.objects[0].layer_height_nm, 300'000);
}

TEST(ResolvePlate, SkirtBrimAndRaftHaveRowsOfTheirOwn) {
  const ResolvedPlate plate = PlateOrDie(
      {{"skirts", "1"}, {"support_material_speed", "50"}},
      {ObjectNamed("brim", {{"brim_width", "5"}, {"support_material_speed", "20"}}),
       ObjectNamed("raft", {{"raft_layers", "3"}, {"brim_width", "5"}}), ObjectNamed("plain")});
  const FdmSettings& fdm = FdmOf(plate.settings);
  const auto towards_holes = [&](int32_t row) {
    return FdmOf(plate.settings).regions[static_cast<size_t>(row)].order.towards_holes;
  };
  const auto speed = [&](int32_t row, Feature feature) {
    return fdm.regions[static_cast<size_t>(row)].motion.speed_mm_s[static_cast<size_t>(feature)];
  };
  EXPECT_FALSE(towards_holes(0));
  EXPECT_TRUE(towards_holes(fdm.objects[0].brim_settings));
  EXPECT_EQ(speed(fdm.objects[0].brim_settings, Feature::kSkirt), 20);
  EXPECT_EQ(speed(fdm.machine.plan.skirt_settings, Feature::kSkirt), 50);
  const std::vector<int32_t>& raft = fdm.objects[1].raft_settings;
  ASSERT_THAT(raft, SizeIs(3));
  EXPECT_DOUBLE_EQ(Density(plate, raft[0]), 0.9);
  EXPECT_DOUBLE_EQ(Density(plate, raft[1]), 1);
  EXPECT_EQ(raft[1], raft[2]);
  EXPECT_EQ(speed(raft[0], Feature::kSupportInterface), 50);
  EXPECT_EQ(fdm.objects[1].brim_settings, 0) << "none with a raft";
  EXPECT_EQ(fdm.objects[2].brim_settings, 0);
  EXPECT_FALSE(plate.settings.slicing.objects[1].on_bed);
  EXPECT_TRUE(plate.settings.slicing.objects[2].on_bed);
  EXPECT_THAT(FdmOf(plate.settings).regions, SizeIs(6));  // two parts, brim, two of the raft, skirt
}

TEST(ResolvePlate, EachObjectHasItsOwnLayerHeightAndSeam) {
  const ResolvedPlate plate =
      PlateOrDie({{"seam_position", "rear"}},
                 {ObjectNamed("a", {{"layer_height", "0.1"}}),
                  ObjectNamed("b", {{"layer_height", "0.3"}, {"seam_position", "nearest"}})});
  ASSERT_THAT(plate.settings.slicing.objects, SizeIs(2));
  EXPECT_EQ(plate.settings.slicing.objects[0].layer_height_nm, 100'000);
  EXPECT_EQ(plate.settings.slicing.objects[1].layer_height_nm, 300'000);
  EXPECT_EQ(FdmOf(plate.settings).objects[0].seam, SeamPosition::kRear);
  EXPECT_EQ(FdmOf(plate.settings).objects[1].seam, SeamPosition::kNearest);
}

TEST(ResolvePlate, CopiesOfAnObjectAreOneObject) {
  const ResolvedPlate plate = PlateOrDie({}, {ObjectNamed("benchy", {}, 12)});
  ASSERT_THAT(plate.objects, SizeIs(1));
  EXPECT_THAT(plate.objects[0].copies, SizeIs(12));
}

TEST(ResolvePlate, EqualObjectsAreCopiesOfOne) {
  SceneObject left = ObjectNamed("box");
  left.instances = {StandingAt(20, 30)};
  SceneObject right = left;
  right.instances = {StandingAt(80, 30)};
  const ResolvedPlate plate = PlateOrDie({}, {left, right});
  ASSERT_THAT(plate.objects, SizeIs(1));
  EXPECT_THAT(plate.objects[0].copies,
              ElementsAre(CopyInput{CopyInput::Place::kOriginAt, {20'000'000, 30'000'000}},
                          CopyInput{CopyInput::Place::kOriginAt, {80'000'000, 30'000'000}}));
}

TEST(ResolvePlate, ObjectsOfDifferentSettingsStayTwo) {
  EXPECT_THAT(
      PlateOrDie({}, {ObjectNamed("box"), ObjectNamed("box", {{"fill_density", "77%"}})}).objects,
      SizeIs(2));
}

TEST(ResolvePlate, ATurnedCopyIsAnObjectOfItsOwn) {
  SceneObject object = ObjectNamed("box");
  object.instances = {StandingAt(20, 30), StandingAt(80, 30, 45), StandingAt(140, 30)};
  const ResolvedPlate plate = PlateOrDie({}, {object});
  ASSERT_THAT(plate.objects, SizeIs(2));
  EXPECT_THAT(plate.objects[0].copies, SizeIs(2));
  EXPECT_THAT(plate.objects[1].copies, SizeIs(1));
}

// If the infill of a part follows the model, the part gets a turned row. The changes of a modifier
// then begin with turned rows.
TEST(ResolvePlate, InfillThatFollowsTheModelTurnsWithACopy) {
  SceneObject object = ObjectNamed("box", {{"align_infill_direction_to_model", "1"}});
  object.parts.push_back(
      PartOf(1, PartRole::kModifier, {{"align_infill_direction_to_model", "0"}}));
  object.instances = {StandingAt(20, 30), StandingAt(80, 30, 30)};
  const ResolvedPlate plate = PlateOrDie({}, {object});
  ASSERT_THAT(plate.objects, SizeIs(2));
  const auto turn_deg = [&](int32_t row) {
    return FdmOf(plate.settings).regions[static_cast<size_t>(row)].infill.turn_rad * 180 /
           3.14159265358979;
  };
  const auto& parts = plate.objects[1].parts;
  EXPECT_EQ(turn_deg(plate.objects[0].parts[0].regions[0]), 0);
  EXPECT_NEAR(turn_deg(parts[0].regions[0]), 30, 1e-9);
  const int32_t inside = parts[1].changes.at(parts[0].regions[0]);
  EXPECT_EQ(turn_deg(inside), 0) << "the modifier's infill does not follow the model";
}

TEST(ResolvePlate, AnUnprintableCopyIsLeftOut) {
  SceneObject object = ObjectNamed("box", {}, 2);
  object.instances[0].printable = false;
  EXPECT_THAT(PlateOrDie({}, {object}).objects[0].copies, SizeIs(1));
  object.instances[1].printable = false;
  EXPECT_EQ(DetailOf(PlateRefusal({}, {object})).reason, Reason::kNothingToPrint);
}

TEST(ResolvePlate, ASettingOfTheJobIsMisplacedInAnObject) {
  const absl::Status refusal =
      PlateRefusal({}, {ObjectNamed("box \"1\"", {{"temperature", "200"}})});
  EXPECT_EQ(DetailOf(refusal).reason, Reason::kSettingMisplaced);
  EXPECT_THAT(std::string(refusal.message()),
              HasSubstr("temperature is a setting of the job and cannot be set for an object"));
  EXPECT_THAT(DetailOf(refusal).metadata, Contains(Pair("setting", "temperature")));
  EXPECT_THAT(DetailOf(refusal).metadata, Contains(Pair("object", "box \"1\"")));
}

TEST(ResolvePlate, ASettingOfTheObjectIsMisplacedInAPart) {
  SceneObject object = ObjectNamed("box");
  object.parts[0].settings = Settings({{"layer_height", "0.1"}});
  EXPECT_EQ(DetailOf(PlateRefusal({}, {object})).reason, Reason::kSettingMisplaced);
}

// Project files contain misplaced settings of their program. Such a setting is reported, and the
// job is not refused.
TEST(ResolvePlate, AMisplacedSettingOfAFileIsTold) {
  SceneObject object = ObjectNamed("box");
  object.settings = Settings({{"temperature", "200"}}, Source::kProfile);
  EXPECT_THAT(TextsOf(PlateOrDie({}, {object}).no_effect),
              Contains("box: temperature = 200: is a setting of the job"));
}

TEST(ResolvePlate, AValueOutOfRangeCountsIfAnObjectSwitchesItsFeatureOn) {
  const std::vector<Setting> job =
      Settings({{"fuzzy_skin", "none"}, {"fuzzy_skin_thickness", "150"}}, Source::kProfile);
  const auto refusal = [&](const Pairs& own) {
    return ResolvePlate(job, std::vector{ObjectNamed("box", own)}, Process::kFdm).status();
  };
  EXPECT_TRUE(refusal({}).ok());
  EXPECT_TRUE(refusal({{"fuzzy_skin", "all"}, {"fuzzy_skin_thickness", "0.3"}}).ok());
  const absl::Status fuzzy = refusal({{"fuzzy_skin", "all"}});
  EXPECT_EQ(DetailOf(fuzzy).reason, Reason::kSettingOutOfRange) << fuzzy;
  EXPECT_EQ(DetailOf(fuzzy).metadata["setting"], "fuzzy_skin_thickness");
  EXPECT_EQ(DetailOf(fuzzy).metadata["object"], "box");
}

TEST(ResolvePlate, AnErrorSaysWhichObject) {
  const absl::Status refusal =
      PlateRefusal({}, {ObjectNamed("good"), ObjectNamed("bad", {{"fill_density", "many"}})});
  EXPECT_EQ(DetailOf(refusal).reason, Reason::kSettingMalformed);
  EXPECT_THAT(std::string(refusal.message()), HasSubstr("object \"bad\""));
}

TEST(ResolvePlate, AnUnknownSettingOfAnObjectIsRefused) {
  EXPECT_EQ(DetailOf(PlateRefusal({}, {ObjectNamed("box", {{"fill_densty", "10%"}})})).reason,
            Reason::kSettingUnknown);
}

TEST(ResolvePlate, ARangeMustBeOne) {
  for (const auto& [from, to] : {std::pair{5.0, 5.0}, {7.0, 5.0}, {-1.0, 5.0}, {0.0, 1e9}}) {
    SceneObject object = ObjectNamed("box");
    object.ranges.push_back({from, to, {}});
    EXPECT_EQ(DetailOf(PlateRefusal({}, {object})).reason, Reason::kRequestMalformed)
        << from << " " << to;
  }
}

TEST(ResolvePlate, TooManySetsOfSettings) {
  std::vector<SceneObject> objects;
  for (int i = 0; i <= limits::kMaxRegionSettings; ++i)
    objects.push_back(
        ObjectNamed("box", {{"top_infill_extrusion_width", std::to_string(0.3 + i * 0.0001)}}));
  EXPECT_EQ(DetailOf(PlateRefusal({}, objects)).reason, Reason::kRequestTooLarge);
  objects.pop_back();
  EXPECT_TRUE(ResolvePlate({}, objects, Process::kFdm).ok());
}

TEST(ResolvePlate, CopiesWithTooManyRotationsAreRefusedByTheNameOfTheSetting) {
  SceneObject object = ObjectNamed("box", {{"align_infill_direction_to_model", "1"}});
  object.instances.clear();
  for (int i = 0; i < limits::kMaxRegionSettings; ++i)
    object.instances.push_back(StandingAt(20, 30, 0.1 * (i + 1)));
  const absl::Status refusal = PlateRefusal({}, {object});
  EXPECT_EQ(DetailOf(refusal).reason, Reason::kSettingOutOfRange) << refusal;
  EXPECT_EQ(DetailOf(refusal).metadata["setting"], "align_infill_direction_to_model");
  EXPECT_EQ(DetailOf(refusal).metadata["object"], "box");
  object.settings.clear();
  EXPECT_TRUE(PlateRefusal({}, {object}).ok()) << "without the setting, rotations share a row";
}

// The text is the cache's key and the end of the G-code, so it contains the settings of objects.
TEST(ResolvePlate, TheTextSaysWhatObjectsHave) {
  SceneObject object = ObjectNamed("box", {{"fill_density", "20%"}});
  object.ranges.push_back({5, 10, Settings({{"perimeters", "4"}})});
  const std::string text = PlateOrDie({}, {object}).effective_text;
  EXPECT_THAT(text,
              HasSubstr(R"(object_settings = [{"object":"box","settings":{"fill_density":"20%"})"));
  EXPECT_THAT(text, HasSubstr(R"("perimeters":"4")"));
}

// Regions with the same wall settings have the same wall class: walls go around all of them
// together.
TEST(ResolvePlate, RegionsThatDifferInFillingShareWalls) {
  SceneObject object = ObjectNamed("box");
  object.parts.push_back(PartOf(1, PartRole::kModifier, {{"fill_density", "60%"}}));
  object.parts.push_back(PartOf(2, PartRole::kModifier, {{"perimeters", "7"}}));
  const ResolvedPlate plate = PlateOrDie({}, {object});
  const auto wall_class = [&](int32_t row) {
    return FdmOf(plate.settings).regions[static_cast<size_t>(row)].walls.wall_class;
  };
  const auto& parts = plate.objects[0].parts;
  const int32_t part = parts[0].regions[0];
  EXPECT_EQ(wall_class(part), wall_class(parts[1].changes.at(part)));
  EXPECT_NE(wall_class(part), wall_class(parts[2].changes.at(part)));
}

TEST(ResolvePlate, IsCancelledBetweenSets) {
  SceneObject object;
  object.parts.resize(1);
  object.instances.resize(1);
  for (int i = 0; i < 9; ++i)
    object.ranges.push_back({1.0 * i, 1.0 * i + 1, {{"perimeters", std::to_string(i)}}});
  int asked = 0;
  const CancelToken third([&] { return ++asked == 3; });
  const std::vector<SceneObject> objects = {object};
  EXPECT_TRUE(absl::IsCancelled(ResolvePlate({}, objects, Process::kFdm, third).status()));
  EXPECT_EQ(asked, 3);
}

}  // namespace
}  // namespace slicefarm::config::plate_test
