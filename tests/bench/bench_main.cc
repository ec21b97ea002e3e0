#include <array>
#include <cstdio>
#include <string_view>

#include "tests/bench/benchmarks.h"

namespace {

struct Benchmark {
  std::string_view name;
  std::string_view what;
  int (*run)();
};

/// slicefarm-bench NAME prints `key value` rows. Add a benchmark by a line here.
constexpr std::array kBenchmarks = {
    Benchmark{"slice", "1,000,000 triangles into 400 layers on one thread",
              slicefarm::bench::BenchSlice},
    Benchmark{"hop", "bytes and time per layer between processes, fused and split",
              slicefarm::bench::BenchHop},
};

}  // namespace

int main(int argc, char** argv) {
  const std::string_view wanted = argc == 2 ? argv[1] : "";
  for (const Benchmark& benchmark : kBenchmarks)
    if (benchmark.name == wanted) return benchmark.run();
  std::fprintf(stderr, "usage: slicefarm-bench NAME\n");
  for (const Benchmark& benchmark : kBenchmarks)
    std::fprintf(stderr, "  %-12s %s\n", benchmark.name.data(), benchmark.what.data());
  return 2;
}
