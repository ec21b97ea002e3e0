#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "tests/bench/benchmarks.h"

namespace {

struct Benchmark {
  std::string_view name;
  std::string_view argument;  ///< required argument after the name; empty: none
  std::string_view what;
  int (*run)(const std::string& argument);
};

/// Benchmarks of `slicefarm-bench NAME [ARGUMENT]`, which prints `key value` rows. A new benchmark
/// needs a line here.
constexpr std::array kBenchmarks = {
    Benchmark{"slice", "", "1,000,000 triangles into 400 layers on one thread",
              [](const std::string&) { return slicefarm::bench::BenchSlice(); }},
    Benchmark{"planning", "",
              "100,000 layers x 100 islands, and as many islands through the service",
              [](const std::string&) { return slicefarm::bench::BenchPlanning(); }},
    Benchmark{"hop", "", "bytes and time per layer between processes, fused and split",
              [](const std::string&) { return slicefarm::bench::BenchHop(); }},
    Benchmark{"hop-tls", "CERTS", "the same with TLS, by certificates of deploy/dev-certs.sh",
              slicefarm::bench::BenchHopWithTls},
    Benchmark{"mesh", "", "reading meshes in processes of their own, and directly",
              [](const std::string&) { return slicefarm::bench::BenchMesh(); }},
    Benchmark{"walls", "DIR_OF_OUTLINES", "walls of variable width beside a Voronoi diagram alone",
              slicefarm::bench::BenchWalls},
    Benchmark{"exposure", "DIR_OF_POLYGONS",
              "laser vectors of a lattice; convex pieces beside CGAL's",
              slicefarm::bench::BenchExposure},
    Benchmark{"lattice", "", "1,000 layers of a million laser vectors, a range at a time; minutes",
              [](const std::string&) { return slicefarm::bench::BenchLattice(); }},
    Benchmark{"rings", "DIR_OF_POLYGONS",
              "how much of outlines a laser's rings cover, and how often",
              slicefarm::bench::BenchRings},
    Benchmark{"waterline", "DIR_OF_MODELS", "loops of a milling cutter beside OpenCAMlib's",
              slicefarm::bench::BenchWaterline},
};

}  // namespace

int main(int argc, char** argv) {
  const std::string_view wanted = argc > 1 ? argv[1] : "";
  for (const Benchmark& benchmark : kBenchmarks) {
    const bool has_argument = !benchmark.argument.empty();
    if (benchmark.name == wanted && argc == (has_argument ? 3 : 2))
      return benchmark.run(has_argument ? argv[2] : "");
  }
  std::fprintf(stderr, "usage: slicefarm-bench NAME [ARGUMENT]\n");
  for (const Benchmark& benchmark : kBenchmarks) {
    std::fprintf(stderr, "  %-8s %-16s %s\n", benchmark.name.data(), benchmark.argument.data(),
                 benchmark.what.data());
  }
  return 2;
}
