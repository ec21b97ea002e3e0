#include "common/base/span_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

namespace slicefarm::span_log_test {
namespace {

using testing::ElementsAre;
using testing::Field;
using testing::Pair;

TEST(SpanLog, KeepsWhatWasInScope) {
  SpanLog log(1'000'000, 10);
  {
    const ScopedSpan outer(&log, "outer");
    ScopedSpan inner(&log, "inner", "there");
    inner.Set("layers", "7");
  }
  const auto spans = log.spans();
  ASSERT_THAT(spans, ElementsAre(Field(&Span::name, "inner"), Field(&Span::name, "outer")));
  EXPECT_THAT(spans[0].facts, ElementsAre(Pair("layers", "7")));
  EXPECT_EQ(spans[0].track, "there");
  EXPECT_EQ(spans[1].track, "");
  EXPECT_GE(spans[1].begin_us, 1'000'000);
  EXPECT_GE(spans[0].begin_us, spans[1].begin_us);
  EXPECT_GE(spans[0].end_us, spans[0].begin_us);
  EXPECT_GE(spans[1].end_us, spans[0].end_us);
}

TEST(SpanLog, IsBounded) {
  SpanLog log(0, 2);
  for (int i = 0; i < 5; ++i) const ScopedSpan span(&log, std::to_string(i));
  EXPECT_THAT(log.spans(), ElementsAre(Field(&Span::name, "0"), Field(&Span::name, "1")));
  EXPECT_EQ(log.dropped(), 3);
}

TEST(SpanLog, TakesSpansFromManyThreads) {
  SpanLog log(0, 1000);
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&log] {
      for (int k = 0; k < 100; ++k) const ScopedSpan span(&log, "work");
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(log.spans().size(), 400);
}

}  // namespace
}  // namespace slicefarm::span_log_test
