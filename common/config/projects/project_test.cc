#include "common/config/projects/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::config::project_test {
namespace {

using testing::Contains;
using testing::ElementsAre;

/// Returns a project of two objects. The second object has two copies, and one of them is not
/// printed.
Project TwoObjects() {
  Project project;
  project.settings = {{"layer_height", "0.2"}};
  project.objects.resize(2);
  project.objects[0].name = "a";
  project.objects[0].instances.resize(1);
  project.objects[1].name = "b";
  project.objects[1].instances.resize(2);
  project.objects[1].instances[0].printable = false;
  project.objects[1].parts.resize(1);
  project.objects[1].parts[0].name = "body";
  return project;
}

/// Returns the project of TwoObjects on two plates, with an empty plate between them.
Project OnPlates() {
  Project project = TwoObjects();
  project.plates.resize(3);
  project.plates[0].members = {{0, 0}};
  project.plates[2].members = {{1, 1}, {1, 0}};
  project.plates[2].name = "right";
  return project;
}

TEST(JobOfProject, TakesWhatIsPrintedWithTheSourceOfAProfile) {
  const auto job = JobOfProject(TwoObjects(), 0);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->objects.size(), 2);
  EXPECT_EQ(job->objects[1].instances.size(), 1);
  EXPECT_THAT(job->settings, ElementsAre(Setting{"layer_height", "0.2", Source::kProfile}));
  EXPECT_EQ(*JobOfProject(TwoObjects(), 1), *job);
}

TEST(JobOfProject, WarnsOfWhatIsNoSetting) {
  Project project = TwoObjects();
  project.dialect = SettingsDialect::kOrca;
  project.settings = {{"no_such", "1"}};
  project.without_effect = {"painted seams of `b`"};
  const auto job = JobOfProject(project, 0);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_THAT(
      job->without_effect,
      ElementsAre("painted seams of `b`",
                  "no_such: no setting of OrcaSlicer, which ignores it (as of February 2026)"));
  EXPECT_THAT(job->warnings, ElementsAre("painted seams of `b`: without effect"));
}

TEST(JobOfProject, WarnsOfSettingsThatMakeAnotherPrint) {
  Project project = TwoObjects();
  project.dialect = SettingsDialect::kOrca;
  project.settings = {{"no_such", "1"},
                      {"brim_type", "painted"},
                      {"skirt_type", "combined"},
                      {"sparse_infill_pattern", "no_such"}};
  project.objects[1].settings = {{"post_process", "a.py"}, {"sparse_infill_pattern", "grid"}};
  const auto job = JobOfProject(project, 0);
  ASSERT_TRUE(job.ok()) << job.status();
  EXPECT_THAT(
      job->without_effect,
      ElementsAre("brim_type = painted", "sparse_infill_pattern = no_such",
                  "b: post_process = a.py",
                  "no_such: no setting of OrcaSlicer, which ignores it (as of February 2026)"));
  EXPECT_EQ(job->warnings.size(), 3u);
}

TEST(JobOfProject, PlaceholdersAreThoseOfTheFilamentInUse) {
  struct Case {
    const char* name;
    const char* of_object;
    const char* of_part;
    const char* want;
  };
  for (const Case& c :
       {Case{"None", "0", "0", "V{180}"}, Case{"First", "1", "0", "V{180}"},
        Case{"OfObject", "2", "0", "V{100}"}, Case{"OfPart", "0", "2", "V{100}"},
        Case{"OfPartAlone", "1", "2", "V{100}"}, Case{"Beyond", "9", "0", "V{180}"}}) {
    Project project = TwoObjects();
    project.dialect = SettingsDialect::kOrca;
    project.settings = {{"machine_start_gcode", "V[min_vitrification_temperature]"},
                        {"temperature_vitrification", R"(["180", "100"])"}};
    for (SceneObject& object : project.objects) {
      object.settings = {{"extruder", c.of_object}};
      object.parts.resize(1);
      object.parts[0].settings = {{"extruder", c.of_part}};
    }
    const auto job = JobOfProject(project, 0);
    ASSERT_TRUE(job.ok()) << job.status();
    EXPECT_THAT(job->settings, Contains(Setting{"start_gcode", c.want, Source::kProfile}))
        << c.name;
  }
}

TEST(JobOfProject, NothingToPrintIsAnError) {
  Project project = TwoObjects();
  for (SceneObject& object : project.objects)
    for (Instance& instance : object.instances) instance.printable = false;
  EXPECT_EQ(DetailOf(JobOfProject(project, 0).status()).reason, Reason::kNothingToPrint);
  EXPECT_EQ(DetailOf(JobOfProject(OnPlates(), 2).status()).reason, Reason::kNothingToPrint);
}

TEST(JobOfProject, WantsToKnowWhichPlate) {
  const absl::Status status = JobOfProject(OnPlates(), 0).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kRequestMalformed);
  EXPECT_EQ(DetailOf(status).metadata.at("field"), "plate");
  EXPECT_EQ(DetailOf(status).metadata.at("plates"), "3");
  EXPECT_NE(status.message().find("1, 3 (\"right\")"), std::string_view::npos) << status;
  for (const int plate : {-1, 4}) {
    EXPECT_EQ(DetailOf(JobOfProject(OnPlates(), plate).status()).reason, Reason::kRequestMalformed);
  }
}

TEST(JobOfProject, TheOnlyPlateWithObjectsNeedsNoName) {
  Project project = OnPlates();
  project.plates[0].members.clear();
  const auto job = JobOfProject(project, 0);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->objects.size(), 1);
  EXPECT_EQ(job->objects[0].name, "b");
  EXPECT_EQ(job->objects[0].instances.size(), 1);
}

TEST(JobOfProject, APlatesSettingsWinOverTheProjects) {
  Project project = OnPlates();
  project.plates[2].settings = {{"layer_height", "0.3"}};
  const auto job = JobOfProject(project, 3);
  ASSERT_TRUE(job.ok()) << job.status();
  ASSERT_EQ(job->settings.size(), 2);
  EXPECT_EQ(job->settings.back().value, "0.3");
}

TEST(InPrusaNames, TranslatesSettingsOfEveryPlace) {
  Project project = TwoObjects();
  project.dialect = SettingsDialect::kOrca;
  project.settings = {{"wall_loops", "3"}, {"nozzle_diameter", "[\"0.4\"]"}, {"no_such", "1"}};
  project.objects[0].settings = {{"wall_loops", "4"}, {"extruder", "0"}};
  project.objects[1].parts[0].settings = {{"sparse_infill_density", "40%"}, {"odd", "1"}};
  project.objects[1].ranges.push_back({0, 5, {{"outer_wall_line_width", "110%"}}});
  const Project named = InPrusaNames(project);
  EXPECT_EQ(named.dialect, SettingsDialect::kPrusa);
  EXPECT_THAT(named.settings, Contains(Setting{"perimeters", "3", Source::kProfile}));
  EXPECT_THAT(named.objects[0].settings, ElementsAre(Setting{"perimeters", "4", Source::kProfile}));
  EXPECT_THAT(named.objects[1].parts[0].settings,
              ElementsAre(Setting{"fill_density", "40%", Source::kProfile}));
  // Percentage of the nozzle diameter, which only the project gives.
  EXPECT_THAT(named.objects[1].ranges[0].settings,
              ElementsAre(Setting{"external_perimeter_extrusion_width", "0.44", Source::kProfile}));
  EXPECT_THAT(
      named.without_effect,
      ElementsAre(
          "no_such: no setting of OrcaSlicer, which ignores it (as of February 2026)",
          "b, body: odd: no setting of OrcaSlicer, which ignores it (as of February 2026)"));
  EXPECT_EQ(InPrusaNames(named), named);
}

}  // namespace
}  // namespace slicefarm::config::project_test
