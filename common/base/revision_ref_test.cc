#include "common/base/revision_ref.h"

#include <gtest/gtest.h>

#include <string>

#include "common/base/error.h"

namespace slicefarm::revision_ref_test {
namespace {

TEST(ParseRevisionRef, ReadsTheFormThatCommandsPrint) {
  EXPECT_EQ(*ParseRevisionRef("mk4"), (RevisionRef{"mk4", 0}));
  EXPECT_EQ(*ParseRevisionRef("mk4@12"), (RevisionRef{"mk4", 12}));
  EXPECT_EQ(*ParseRevisionRef("a@b@2"), (RevisionRef{"a@b", 2}));
}

TEST(ParseRevisionRef, RefusesOtherRevisions) {
  for (const char* text : {"mk4@", "mk4@0", "mk4@-1", "mk4@x", "mk4@1.5", "mk4@@", "@", "mk4@ 1",
                           "mk4@1 ", "mk4@+1", "mk4@99999999999999999999"})
    EXPECT_EQ(DetailOf(ParseRevisionRef(text).status()).reason, Reason::kRequestMalformed) << text;
}

TEST(ParseRevisionRef, NamesATextThatItRefuses) {
  const auto message = [](const std::string& text) {
    return std::string(ParseRevisionRef(text).status().message());
  };
  EXPECT_EQ(message("mk4@x"), "mk4@x: after '@', the number of a revision is needed");
  EXPECT_EQ(message("\xc3@x"), "\\303@x: after '@', the number of a revision is needed");
  EXPECT_LT(message(std::string(10'000, 'a') + "@x").size(), 200u);
}

}  // namespace
}  // namespace slicefarm::revision_ref_test
