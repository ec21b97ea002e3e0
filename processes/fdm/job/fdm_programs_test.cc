#include "processes/fdm/job/fdm_programs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "common/base/error.h"

namespace slicefarm::coordinator::fdm_programs_test {
namespace {

using testing::ElementsAre;

/// Returns a layer of a pass. A layer without a text has no beads.
LayerProgram Layer(int32_t index, std::string text, int32_t pass = 0) {
  LayerProgram program;
  program.frame.index = index;
  program.pass = pass;
  if (!text.empty()) program.stats.features[0] = {2, 3, 4, 5};
  program.gcode = std::move(text);
  return program;
}

class FdmProgramsTest : public testing::Test {
 protected:
  std::vector<SpooledProgram> SpooledOf(std::vector<LayerProgram> programs) {
    return *Spooled(std::move(programs), *spool_);
  }
  std::string Whole(ProgramEnvelope frame, const std::vector<SpooledProgram>& programs) {
    return *WholeProgram(std::move(frame), programs, {}, std::move(spool_), CancelToken())->Whole();
  }

  std::unique_ptr<SpoolFile> spool_ = *SpoolFile::Make("");
};

TEST_F(FdmProgramsTest, TextsAreInTheSpoolAlone) {
  const auto programs = SpooledOf({Layer(0, "zero"), Layer(1, "one")});
  EXPECT_EQ(programs[1].program.gcode, "");
  EXPECT_EQ(programs[1].program.frame.index, 1);
  EXPECT_EQ(programs[1].text.size, 3);
}

TEST_F(FdmProgramsTest, PassesFollowEachOtherAndEndWithTheirBeads) {
  const auto programs = InPrintOrder(
      SpooledOf({Layer(0, "a"), Layer(0, "A", 1), Layer(1, ""), Layer(2, "c"), Layer(3, "")}), 4);
  ASSERT_TRUE(programs.ok()) << programs.status();
  std::vector<std::pair<int, int>> order;
  for (const SpooledProgram& spooled : *programs)
    order.emplace_back(spooled.program.pass, spooled.program.frame.index);
  EXPECT_THAT(order,
              ElementsAre(std::pair(0, 0), std::pair(0, 1), std::pair(0, 2), std::pair(1, 0)));
}

TEST_F(FdmProgramsTest, LayersThatAreMissingOrWithoutBeadsAreErrors) {
  const auto reason = [&](std::vector<LayerProgram> programs, size_t layers) {
    return DetailOf(InPrintOrder(SpooledOf(std::move(programs)), layers).status()).reason;
  };
  EXPECT_EQ(reason({Layer(0, "a")}, 2), Reason::kInternal);
  EXPECT_EQ(reason({Layer(1, "b")}, 2), Reason::kInternal);
  EXPECT_EQ(reason({Layer(0, "a"), Layer(2, "c")}, 3), Reason::kInternal);
  EXPECT_EQ(reason({Layer(0, ""), Layer(1, "")}, 2), Reason::kNothingToPrint);
}

TEST_F(FdmProgramsTest, SumsUpLayers) {
  const ProgramSummary summary = Summarize(SpooledOf({Layer(0, "a"), Layer(1, ""), Layer(2, "c")}));
  ASSERT_EQ(summary.layers.size(), 3u);
  EXPECT_TRUE(summary.layers[1].empty);
  EXPECT_DOUBLE_EQ(summary.total.TimeS(), 4);
}

TEST_F(FdmProgramsTest, RetractionsThatTheJoinLeavesOutAreNotCounted) {
  for (const bool retracted : {true, false}) {
    LayerProgram below = Layer(0, "a"), above = Layer(1, "b");
    below.ends_retracted = retracted;
    above.mode_lines = {{0, 1, MachineMode::kFilament, std::string(kRetracted)}};
    below.stats.retractions = above.stats.retractions = 3;
    EXPECT_EQ(Summarize(SpooledOf({below, above})).total.retractions, retracted ? 5 : 6);
  }
}

TEST_F(FdmProgramsTest, CopiesAreSummedOverLayers) {
  LayerProgram first = Layer(0, "a"), second = Layer(1, "b");
  first.copies = {{0, {1, 2, 3, 4}}, {1, {10, 20, 30, 40}}};
  second.copies = {{1, {100, 200, 300, 400}}};
  const auto programs = SpooledOf({first, second});
  std::vector<CopySummary> copies(2);
  ASSERT_TRUE(AddCopyUses(programs, copies).ok());
  EXPECT_EQ(copies[0].use, (FeatureUse{1, 2, 3, 4}));
  EXPECT_EQ(copies[1].use, (FeatureUse{110, 220, 330, 440}));
  copies.resize(1);
  EXPECT_EQ(DetailOf(AddCopyUses(programs, copies)).reason, Reason::kInternal);
}

TEST_F(FdmProgramsTest, SubstitutionsThatMakeLayersTooLongAreRefused) {
  struct Case {
    const char* name;
    std::vector<std::string> items;
    bool refused;
  };
  const Case cases[] = {
      {"one longer word", {"x", "yy", "", ""}, false},
      {"a long text for each word", {"x", std::string(60'000, 'y'), "", ""}, true},
  };
  for (const Case& c : cases) {
    spool_ = *SpoolFile::Make("");
    const auto programs = SpooledOf({Layer(0, "one"), Layer(1, std::string(100, 'x'))});
    const auto substitutions = *gcode::Substitutions::Of(c.items);
    const auto whole = WholeProgram({}, programs, substitutions, std::move(spool_), CancelToken());
    if (!c.refused) {
      ASSERT_TRUE(whole.ok()) << c.name << whole.status();
      EXPECT_EQ(*whole->Whole(), "one" + std::string(200, 'y'));
      continue;
    }
    const ErrorDetail detail = DetailOf(whole.status());
    EXPECT_EQ(detail.reason, Reason::kRequestTooLarge) << c.name << whole.status();
    EXPECT_EQ(detail.metadata.at("setting"), "gcode_substitutions");
  }
}

TEST_F(FdmProgramsTest, SubstitutionsAreCancelled) {
  const auto programs = SpooledOf({Layer(0, "x")});
  const auto substitutions = *gcode::Substitutions::Of({"x", "y", "", ""});
  const CancelToken cancelled([] { return true; });
  const auto whole = WholeProgram({}, programs, substitutions, std::move(spool_), cancelled);
  EXPECT_TRUE(absl::IsCancelled(whole.status())) << whole.status();
}

TEST_F(FdmProgramsTest, LaterTextsGoToTheirPlacesInTheLayers) {
  LayerProgram first = Layer(0, "[|]");
  first.code_at = {1, 2};
  LayerProgram second = Layer(1, "(x)");  // it already contains its own texts
  LayerProgram third = Layer(2, "<>");
  third.code_at = {0, 2};
  ProgramEnvelope frame;
  frame.prologue = "begin ";
  frame.layer_prefixes = {"0:", "1:"};
  frame.layer_code = {"a", "b", "", "", "c", "d"};
  frame.epilogue = " end";
  EXPECT_EQ(Whole(std::move(frame), SpooledOf({first, second, third})),
            "begin 0:[a|b]1:(x)c<>d end");
}

}  // namespace
}  // namespace slicefarm::coordinator::fdm_programs_test
