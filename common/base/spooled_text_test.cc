#include "common/base/spooled_text.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "common/base/error.h"
#include "common/base/temp_directory_test.h"

namespace slicefarm::spooled_text_test {
namespace {

constexpr auto kBlock = static_cast<size_t>(SpooledText::kBlockBytes);

std::unique_ptr<SpoolFile> NewSpool() { return *SpoolFile::Make(""); }

/// Returns bytes with values that identify their position.
std::string Counted(size_t size, char first) {
  std::string text(size, first);
  for (size_t i = 0; i < size; ++i) text[i] = static_cast<char>(first + i % 61);
  return text;
}

TEST(SpooledText, IsItsPiecesInTheirOrder) {
  auto spool = NewSpool();
  const SpoolFile::Chunk last = *spool->Add("the spool's first");
  const SpoolFile::Chunk first = *spool->Add("its second, ");
  SpooledText text(std::move(spool));
  text.Add(first);
  text.Add(std::string("of memory, "));
  text.Add(SpoolFile::Chunk{last.offset + 12, 5});
  text.Add(last);
  EXPECT_EQ(*text.Whole(), "its second, of memory, firstthe spool's first");
  EXPECT_EQ(text.size(), std::ssize(*text.Whole()));
}

TEST(SpooledText, AnyPartOfItCanBeRead) {
  auto spool = NewSpool();
  const SpoolFile::Chunk chunk = *spool->Add("0123456789");
  SpooledText text(std::move(spool));
  text.Add(std::string("abc"));
  text.Add(chunk);
  text.Add(SpoolFile::Chunk{4, 2});
  text.Add(std::string("xyz"));
  const std::string whole = *text.Whole();
  for (int64_t offset = 0; offset <= text.size() + 1; ++offset) {
    for (int64_t limit = 0; limit <= text.size() + 1; ++limit) {
      const auto read = text.Read(offset, limit);
      ASSERT_TRUE(read.ok()) << read.status();
      const size_t from = std::min<size_t>(offset, whole.size());
      EXPECT_EQ(*read, whole.substr(from, limit)) << offset << " " << limit;
    }
  }
  text.Add(SpoolFile::Chunk{9, 2});  // the spool has but one of them
  EXPECT_EQ(DetailOf(text.Read(0, text.size()).status()).reason, Reason::kStoreFailed);
}

TEST(SpooledText, ComesInWholeBlocksHoweverItsPiecesLie) {
  for (const size_t piece : {size_t{1'000}, kBlock - 1, kBlock, kBlock + 1, 3 * kBlock}) {
    auto spool = NewSpool();
    const std::string written = Counted(piece, 'A');
    const SpoolFile::Chunk chunk = *spool->Add(written);
    SpooledText text(std::move(spool));
    std::string expected;
    for (int i = 0; i < 3; ++i) {
      text.Add(chunk);
      text.Add(Counted(7 * i, 'a'));
      expected += written + Counted(7 * i, 'a');
    }
    for (int again = 0; again < 2; ++again) {
      std::string got;
      EXPECT_TRUE(text.ForEachBlock([&](std::string_view bytes) {
                        EXPECT_EQ(got.size() % kBlock, 0u) << "only the last block is short";
                        got += bytes;
                        return absl::OkStatus();
                      })
                      .ok());
      EXPECT_TRUE(got == expected) << piece << " bytes";
    }
  }
}

TEST(SpooledText, OfNothingHasNoBlock) {
  SpooledText text;
  text.Add(std::string());
  EXPECT_TRUE(text.ForEachBlock([](auto) { return absl::InternalError("a block"); }).ok());
  EXPECT_EQ(*text.Whole(), "");
}

TEST(SpooledText, AnErrorOfWhoVisitsEndsIt) {
  const SpooledText text(std::string(5 * kBlock, 'x'));
  int blocks = 0;
  EXPECT_TRUE(absl::IsAborted(text.ForEachBlock(
      [&](auto) { return ++blocks == 2 ? absl::AbortedError("enough") : absl::OkStatus(); })));
  EXPECT_EQ(blocks, 2);
}

TEST(SpoolFile, TakesTextsFromManyThreads) {
  auto spool = NewSpool();
  constexpr int kThreads = 4;
  constexpr int kTexts = 200;
  std::vector<std::vector<SpoolFile::Chunk>> chunks(kThreads);
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      for (int i = 0; i < kTexts; ++i)
        chunks[t].push_back(
            *spool->Add(Counted(static_cast<size_t>(i), static_cast<char>('A' + t))));
    });
  for (std::thread& thread : threads) thread.join();
  SpooledText text(std::move(spool));
  std::string expected;
  for (int t = 0; t < kThreads; ++t)
    for (int i = 0; i < kTexts; ++i) {
      text.Add(chunks[t][i]);
      expected += Counted(static_cast<size_t>(i), static_cast<char>('A' + t));
    }
  EXPECT_TRUE(*text.Whole() == expected);
}

TEST(SpoolFile, LeavesNoNameBehind) {
  const TempDirectory directory;
  auto spool = *SpoolFile::Make(directory.path());
  ASSERT_TRUE(spool->Add("text").ok());
  EXPECT_TRUE(std::filesystem::is_empty(directory.path()));
}

TEST(SpoolFile, ErrorsAreTyped) {
  EXPECT_EQ(DetailOf(SpoolFile::Make("/nowhere").status()).reason, Reason::kStoreFailed);
  auto spool = NewSpool();
  char byte = 0;
  EXPECT_EQ(DetailOf(spool->ReadAt(0, {&byte, 1})).reason, Reason::kStoreFailed);
}

}  // namespace
}  // namespace slicefarm::spooled_text_test
