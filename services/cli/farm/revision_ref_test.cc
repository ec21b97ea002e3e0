#include "services/cli/farm/revision_ref.h"

#include <gtest/gtest.h>

#include "common/base/error.h"

namespace slicefarm::cli::revision_ref_test {
namespace {

TEST(ParseRevisionRef, ReadsTheFormThatCommandsPrint) {
  EXPECT_EQ(*ParseRevisionRef("mk4"), (RevisionRef{"mk4", 0}));
  EXPECT_EQ(*ParseRevisionRef("mk4@12"), (RevisionRef{"mk4", 12}));
  EXPECT_EQ(*ParseRevisionRef("a@b@2"), (RevisionRef{"a@b", 2}));
}

TEST(ParseRevisionRef, RefusesOtherRevisions) {
  for (const char* text : {"mk4@", "mk4@0", "mk4@-1", "mk4@x", "mk4@1.5", "mk4@@", "@"})
    EXPECT_EQ(DetailOf(ParseRevisionRef(text).status()).reason, Reason::kRequestMalformed) << text;
}

}  // namespace
}  // namespace slicefarm::cli::revision_ref_test
