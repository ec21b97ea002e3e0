#include "services/coordinator/server/api/profile_settings.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "common/model/limits.h"

namespace slicefarm::coordinator::profile_settings_test {
namespace {

TEST(ParseProfileRef, TakesANameAndARevision) {
  EXPECT_EQ(*ParseProfileRef("mk4"), (RevisionRef{"mk4", 0}));
  EXPECT_EQ(*ParseProfileRef("mk4@12"), (RevisionRef{"mk4", 12}));
  EXPECT_EQ(*ParseProfileRef("0.2mm_PLA-fast"), (RevisionRef{"0.2mm_PLA-fast", 0}));
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

/// Profile store in which every name exists.
class AnyProfile : public ProfileStore {
 public:
  absl::StatusOr<ProfileRecord> Put(const NewProfile&, int64_t) override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<ProfileRecord> Get(const std::string&, const std::string& name, int64_t) override {
    return ProfileRecord{.name = name, .revision = 7};
  }
  absl::StatusOr<std::vector<ProfileRecord>> List(const std::string&, const std::string&,
                                                  int32_t) override {
    return absl::UnimplementedError("");
  }
  absl::Status Delete(const std::string&, const std::string&, int64_t, int64_t) override {
    return absl::UnimplementedError("");
  }
  absl::StatusOr<int64_t> Expire(int64_t) override { return absl::UnimplementedError(""); }
};

TEST(WithProfiles, AJobHasAtMostSoMany) {
  AnyProfile profiles;
  v1::JobSpec spec;
  for (int i = 0; i < limits::kMaxJobProfiles; ++i) spec.add_profiles("pla");
  EXPECT_EQ(WithProfiles(spec, "", profiles)->profiles(15), "pla@7");
  spec.add_profiles("pla");
  EXPECT_EQ(DetailOf(WithProfiles(spec, "", profiles).status()).reason, Reason::kRequestTooLarge);
}

TEST(ReadProfile, DamageIsAnError) {
  EXPECT_TRUE(absl::IsDataLoss(ReadProfile({.name = "mk4", .settings = "\xff"}).status()));
}

}  // namespace
}  // namespace slicefarm::coordinator::profile_settings_test
