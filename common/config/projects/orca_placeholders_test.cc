#include "common/config/projects/orca_placeholders.h"

#include <gtest/gtest.h>

namespace slicefarm::config::orca_placeholders_test {
namespace {

std::optional<Placeholder> Meaning(std::string_view name) {
  if (name == "old") return Placeholder{"new"};
  if (name == "value") return ValuePlaceholder("1.5");
  if (name == "below") return ValuePlaceholder("-2");
  if (name == "text") return ValuePlaceholder("a \"b\"\\c\nd");
  return std::nullopt;
}

TEST(ReplacePlaceholders, ReplacesNamesInBracketsOnly) {
  struct Case {
    std::string from, to;
  };
  const std::vector<Case> cases = {
      {"", ""},
      {"G28 ; old", "G28 ; old"},
      {"S[old] S[ old ]", "S[new] S[ new ]"},
      {"S[old[old]] S[other[old]]", "S[new[new]] S[other[new]]"},
      {"S[other] S[old_0]", "S[other] S[old_0]"},
      {"{old} {old+older*2e3}", "{new} {new+older*2e3}"},
      {"{old[old[0]]}", "{new[new[0]]}"},
      {R"({if old=="old"}old{else}[old]{endif})", R"({if new=="old"}old{else}[new]{endif})"},
      {R"({"\"old}" + old})", R"({"\"old}" + new})"},
      {"{old(1)} {old (1)}", "{old(1)} {old (1)}"},
      {"S[value] S[value[other]]", "S{1.5} S{1.5}"},
      {"{value[old[1]]+value [0]}", "{1.5+1.5}"},
      {"{3-below}", "{3-(-2)}"},
      {R"({if text=="x"})", R"({if "a \"b\"\\c\nd"=="x"})"},
      {"[a b] [] {}", "[a b] [] {}"},
      {"old [old {old}", "old [old {old}"},
      {"{old", "{old"},
      {R"({"old)", R"({"old)"},
  };
  for (const Case& c : cases) EXPECT_EQ(ReplacePlaceholders(c.from, Meaning), c.to) << c.from;
}

}  // namespace
}  // namespace slicefarm::config::orca_placeholders_test
