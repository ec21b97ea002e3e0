#include "services/texture/algo/map/thread_random.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <thread>
#include <vector>

#include "services/texture/algo/map/flatten.h"
#include "services/texture/algo/surface/sample_surfaces_test.h"

namespace slicefarm::texture::thread_random_test {
namespace {

TEST(ThreadRandom, IsTheCLibrarysSequence) {
  std::srand(4321);
  std::vector<char> numbers(128);
  random_data data = {};
  initstate_r(4321, numbers.data(), numbers.size(), &data);
  for (int i = 0; i < 1000; ++i) {
    int32_t number = 0;
    random_r(&data, &number);
    ASSERT_EQ(std::rand(), number);
  }
}

// The other thread takes random numbers, as gRPC's threads do.
TEST(ThreadRandom, WhoeverElseTakesNumbersTheMapIsTheSame) {
  const SurfaceMesh mesh = HalfCylinder(40, 20, 40);
  const auto alone = Flatten(mesh, {}, CancelToken());
  ASSERT_TRUE(alone.ok()) << alone.status();
  std::atomic<bool> done = false;
  std::atomic<int> sum = 0;
  std::thread other([&] {
    while (!done) sum += std::rand() & 1;
  });
  for (int round = 0; round < 5; ++round) {
    const auto beside = Flatten(mesh, {}, CancelToken());
    ASSERT_TRUE(beside.ok()) << beside.status();
    EXPECT_EQ(beside->points_mm, alone->points_mm);
  }
  done = true;
  other.join();
  EXPECT_GT(sum, 0);
}

}  // namespace
}  // namespace slicefarm::texture::thread_random_test
