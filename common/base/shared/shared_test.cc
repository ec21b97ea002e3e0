#include "common/base/shared/shared.h"

#include <gtest/gtest.h>

#include <string>
#include <thread>
#include <vector>

namespace slicefarm::shared_test {
namespace {

TEST(Shared, CopiesNameTheSameValue) {
  const Shared<std::string> text = std::string("a");
  const Shared<std::string> copy = text;  // NOLINT(performance-unnecessary-copy-initialization)
  EXPECT_EQ(&*copy, &*text);
  EXPECT_EQ(copy->size(), 1u);
  EXPECT_EQ(*Shared<int>(), 0);
}

TEST(Shared, WhatIsMadeOfItIsMadeOnceForAllCopies) {
  const Shared<std::string> text = std::string("abc");
  int times = 0;
  const auto length = [&](const std::string& value) { return ++times, value.size(); };
  const size_t& first = text.Once(length);
  EXPECT_EQ(first, 3u);
  EXPECT_EQ(&Shared<std::string>(text).Once(length), &first);
  EXPECT_EQ(times, 1);
  EXPECT_EQ(text.Once([](const std::string& value) { return value + "d"; }), "abcd")
      << "of another type";
  EXPECT_EQ(Shared<std::string>(std::string("abc")).Once(length), 3u);
  EXPECT_EQ(times, 2) << "another value, though an equal one";
}

TEST(Shared, ManyThreadsMakeOne) {
  const Shared<int> value = 7;
  std::atomic<int> times = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back(
        [&] { EXPECT_EQ(value.Once([&](int seven) { return ++times, seven + 0.5; }), 7.5); });
  threads.clear();
  EXPECT_EQ(times, 1);
}

}  // namespace
}  // namespace slicefarm::shared_test
