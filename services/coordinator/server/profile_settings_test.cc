#include "services/coordinator/server/profile_settings.h"

#include <gtest/gtest.h>

#include "common/model/error.h"

namespace slicefarm::coordinator {
namespace {

TEST(ParseProfileRef, TakesANameAndARevision) {
  EXPECT_EQ(*ParseProfileRef("mk4"), (ProfileRef{"mk4", 0}));
  EXPECT_EQ(*ParseProfileRef("mk4@12"), (ProfileRef{"mk4", 12}));
  EXPECT_EQ(*ParseProfileRef("0.2mm_PLA-fast"), (ProfileRef{"0.2mm_PLA-fast", 0}));
}

TEST(ParseProfileRef, RefusesTheRest) {
  for (const char* text :
       {"", "@1", "mk4@", "mk4@0", "mk4@-1", "mk4@1x", "mk4@99999999999999999999", "mk4@1@2",
        "mk 4", "../mk4", "mk4\n", "m\xc3\xa9k"}) {
    EXPECT_EQ(DetailOf(ParseProfileRef(text).status()).reason, Reason::kRequestMalformed) << text;
  }
  EXPECT_EQ(DetailOf(CheckProfileName(std::string(256, 'a'))).reason, Reason::kRequestTooLarge);
  EXPECT_TRUE(CheckProfileName(std::string(255, 'a')).ok());
}

TEST(ReadProfile, DamageIsAnError) {
  EXPECT_TRUE(absl::IsDataLoss(ReadProfile({.name = "mk4", .settings = "\xff"}).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator
