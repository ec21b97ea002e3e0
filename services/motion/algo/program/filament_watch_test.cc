#include "services/motion/algo/program/filament_watch.h"

#include <gtest/gtest.h>

namespace slicefarm::motion::filament_watch_test {
namespace {

ProgramMove Push(double mm) { return {{0, 0, 0, 0}, {0, 0, 0, mm}, 30}; }
ProgramMove Print(double mm) { return {{0, 0, 0, 0}, {9, 0, 0, mm}, 30}; }

TEST(FilamentWatch, PairsAreFine) {
  FilamentWatch watch(0, 0);
  for (const auto& move : {Push(0.8), Print(2), Push(-0.8), Push(0.8), Print(1), Push(-0.8)})
    EXPECT_EQ(watch.Add(move, false), std::nullopt);
  EXPECT_NEAR(watch.PrintedMm(), 3.8, 1e-12) << "what primes counts";
}

TEST(FilamentWatch, WipesRetractInPieces) {
  FilamentWatch watch(0, 0);
  for (const auto& move : {Print(2), Print(-0.5), Push(-0.3), Push(0.8), Print(1)})
    EXPECT_EQ(watch.Add(move, false), std::nullopt);
  EXPECT_NEAR(watch.PrintedMm(), 3, 1e-12);
}

TEST(FilamentWatch, OnesThatFail) {
  FilamentWatch watch(0, 0);
  watch.Add(Print(2), false);
  watch.Add(Push(-0.8), false);
  EXPECT_TRUE(watch.Add(Print(1), false)) << "retracted";
  EXPECT_FALSE(watch.Add(Print(1), false)) << "told once";
  EXPECT_TRUE(watch.Add(Push(0.8), false)) << "not retracted";
  EXPECT_FALSE(watch.Add(Push(0.8), true)) << "the user's own";
  watch.ChangeTool(false);
  EXPECT_FALSE(watch.Add(Push(0.8), false)) << "a new filament is primed";
}

TEST(FilamentWatch, CustomCodeIsNotPrintedButItsRetractionStands) {
  FilamentWatch watch(0, 0);
  watch.Add(Push(20), true);
  watch.Add(Push(-0.8), true);
  watch.Add(Push(0.8), false);
  watch.Add(Print(2), false);
  watch.Add(Push(-0.8), false);
  EXPECT_NEAR(watch.PrintedMm(), 2, 1e-12);
}

// Models end G-code.
TEST(FilamentWatch, WhatCustomCodeRetractsInTheEndIsNotPrinted) {
  FilamentWatch watch(0, 0);
  watch.Add(Print(2), false);
  watch.Add(Push(-0.8), false);
  watch.Add(Push(-1), true);
  watch.ChangeTool(true);
  EXPECT_NEAR(watch.PrintedMm(), 2, 1e-12);
}

TEST(FilamentWatch, TooLongAndTooShort) {
  FilamentWatch watch(-0.05, 50);
  EXPECT_TRUE(watch.Add(Push(60), true));
  EXPECT_FALSE(watch.Add(Push(40), true));
  watch.Add(Print(1), false);
  watch.Add(Push(-0.8), false);
  watch.Add(Push(0.75), false);
  EXPECT_FALSE(watch.Add(Print(1), false)) << "restarts leave so much out";
}

}  // namespace
}  // namespace slicefarm::motion::filament_watch_test
