#!/usr/bin/env python3
"""Tests that check_tests.py finds each planted fault of a C++ test, and nothing else."""
import pathlib

from planted_tree import told_of

CHECK = pathlib.Path(__file__).with_name("check_tests.py")
TREE = {
    "common/a/empty_test.cc": (
        "TEST(Lines, AreLong) {\n  for (const Line& line : LinesOf(kSquare)) {\n    EXPECT_GT(line.length, 3);\n  }\n}\n",
    ),
    "common/a/nested_test.cc": (
        "TEST(Lines, AreShort) {\n  const auto lines = LinesOf(\"}\");  // {\n  for (const Line& line : lines)\n"
        "    for (int i : line) EXPECT_LT(i, 3);\n}\n",
    ),
    "common/a/asserted_test.cc": (
        "TEST(Lines, AreThere) {\n  const auto lines = LinesOf(kSquare);\n  ASSERT_FALSE(lines.empty());\n"
        "  for (const Line& line : lines) EXPECT_GT(line.length, 3);\n}\n",
    ),
    "common/a/listed_test.cc": ("TEST(Lines, OfEachSide) {\n  for (int side : {1, 2, 3}) {\n    EXPECT_GT(LengthOf(side), 3);\n  }\n}\n",),
    "common/a/constant_test.cc": ("TEST(Lines, OfCases) {\n  for (const Case& c : kCases) EXPECT_GT(LengthOf(c.side), 3);\n}\n",),
    "common/a/filled_test.cc": (
        "TEST(Lines, OfSides) {\n  const std::vector<int> sides = {1, 2};\n  for (int side : sides) EXPECT_GT(LengthOf(side), 3);\n}\n",
    ),
    "common/a/function_test.cc": (
        "std::vector<int> Sides() {\n  return {\n      1,\n      2,\n  };\n}\n"
        "const std::vector<Case>& Cases() {\n  static const auto* cases = new std::vector<Case>{{\"A\", 1}};\n  return *cases;\n}\n"
        "TEST(Lines, OfFunctions) {\n  for (int side : Sides()) {\n    for (const Case& c : Cases()) EXPECT_GT(LengthOf(side, c), 3);\n  }\n}\n",
    ),
    "common/a/function_empty_test.cc": (
        "std::vector<int> Sides() {\n  std::vector<int> sides;\n  for (int s : Found()) sides.push_back(s);\n  return sides;\n}\n"
        "std::vector<int> Nothing() { return {}; }\n"
        "TEST(Lines, OfFound) {\n  for (int side : Sides()) EXPECT_GT(LengthOf(side), 3);\n}\n"
        "TEST(Lines, OfNothing) {\n  for (int side : Nothing()) EXPECT_GT(LengthOf(side), 3);\n}\n",
    ),
    "common/a/pairs_test.cc": (
        "TEST(Lines, OfPairs) {\n  for (const auto& [a, b] : Pairs{{\"a\", \"b\"}}) EXPECT_GT(LengthOf(a, b), 3);\n}\n"
        "TEST(Lines, OfNoPairs) {\n  for (const auto& [a, b] : Pairs{}) EXPECT_GT(LengthOf(a, b), 3);\n}\n",
    ),
    "common/a/letters_test.cc": (
        "TEST(Lines, OfLetters) {\n  for (const char c : std::string(\"AB\")) EXPECT_GT(LengthOf(c), 3);\n}\n"
        "TEST(Lines, OfNoLetters) {\n  for (const char c : std::string(\"\")) EXPECT_GT(LengthOf(c), 3);\n}\n",
    ),
    "tests/clock_test.cc": ("TEST(Lines, AreFast) {\n  Work();\n  EXPECT_LT(std::chrono::steady_clock::now() - begin, kLimit);\n}\n",),
    "tests/sleep_test.cc": ("TEST(Lines, Arrive) {\n  std::this_thread::sleep_for(kWhile);\n  EXPECT_TRUE(arrived);\n}\n",),
    "tests/stub_test.cc": ("namespace slicefarm::stub_test {\nnamespace {}  // namespace\n}  // namespace slicefarm::stub_test\n",),
}
EXPECTED = [
    "common/a/empty_test.cc:1: empty: Lines.AreLong passes without results",
    "common/a/function_empty_test.cc:10: empty: Lines.OfNothing passes without results",
    "common/a/function_empty_test.cc:7: empty: Lines.OfFound passes without results",
    "common/a/letters_test.cc:4: empty: Lines.OfNoLetters passes without results",
    "common/a/nested_test.cc:1: empty: Lines.AreShort passes without results",
    "common/a/pairs_test.cc:4: empty: Lines.OfNoPairs passes without results",
    "tests/clock_test.cc:3: clock",
    "tests/sleep_test.cc:2: sleep",
    "tests/stub_test.cc:2: stub",
]


def main():
    said = sorted(told_of(CHECK, TREE))
    assert said == EXPECTED, "\n".join(said)
    print(f"{len(said)} planted faults found, nothing else")


if __name__ == "__main__":
    main()
