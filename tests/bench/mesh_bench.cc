#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "common/stage/slice_input_test.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "services/slicing/algo/sample_meshes_test.h"
#include "services/slicing/sandbox/sandboxed_mesh_source.h"
#include "tests/bench/benchmarks.h"
#include "tests/corpus_file.h"

namespace slicefarm::bench {
namespace {

using slicing::MakeDirectMeshSource;
using slicing::MeshSource;
using slicing::SandboxedMeshSource;

constexpr int kRuns = 9;

double Seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) / 1e6;
}

/// Returns the CPU time of this program and of the readers that have ended.
double CpuSeconds() {
  double seconds = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage usage = {};
    getrusage(who, &usage);
    seconds += Seconds(usage.ru_utime) + Seconds(usage.ru_stime);
  }
  return seconds;
}

/// Prints the shortest time of a few runs. Returns false if a run failed.
template <typename Work>
bool Measure(const std::string& what, const std::string& bytes, const Work& work) {
  using Clock = std::chrono::steady_clock;
  double wall_s = 1e9, cpu_s = 1e9;
  for (int run = 0; run < kRuns; ++run) {
    std::string copy = bytes;
    const double cpu = CpuSeconds();
    const auto wall = Clock::now();
    if (!work(std::move(copy))) return false;
    wall_s = std::min(wall_s, std::chrono::duration<double>(Clock::now() - wall).count());
    cpu_s = std::min(cpu_s, CpuSeconds() - cpu);
  }
  std::printf("%s_wall_ms %.2f\n%s_cpu_ms %.2f\n", what.c_str(), wall_s * 1e3, what.c_str(),
              cpu_s * 1e3);
  return true;
}

std::unique_ptr<MeshSource> Sandboxed() {
  return std::make_unique<SandboxedMeshSource>(
      slicing::SandboxOptions{.program = SLICEFARM_BIN "/slicefarm-mesh-reader"});
}

bool MeasureFile(const std::string& name, const std::string& bytes) {
  bool sound = true;
  for (const bool sandboxed : {false, true}) {
    const auto source = [sandboxed] { return sandboxed ? Sandboxed() : MakeDirectMeshSource(); };
    const std::string prefix = name + (sandboxed ? "_sandboxed" : "_direct");
    const auto reader = source();
    sound &= Measure(prefix + "_read", bytes, [&](std::string file) {
      return reader->Read(std::move(file), MeshFormat::kStl, 1e4, slicing::ReadDepth::kMeshes, {})
          .ok();
    });
    const auto stage = slicing::MakeLocalSlicing(source());
    sound &= Measure(prefix + "_slice", bytes, [&](std::string file) {
      return stage->Slice({}, InputOf({{name, MeshFormat::kStl, std::move(file)}}), {}).ok();
    });
  }
  return sound;
}

}  // namespace

/// Measures the cost of reading meshes in separate processes, beside reading them directly. The
/// meshes are the smallest possible one, the benchy, and a torus of a million triangles. Prints the
/// times of the reading alone and of the whole slicing stage, on one thread.
int BenchMesh() {
  const bool least = Measure("least_sandboxed_read", "", [](std::string) {
    return SandboxedMeshSource({.program = SLICEFARM_BIN "/slicefarm-mesh-reader"}).Probe().ok();
  });
  const slicing::TorusShape torus = {
      .ring_radius = 60, .tube_radius = 20, .around = 1000, .sides = 500};
  const bool sound = MeasureFile("benchy", CorpusFile("models/benchy.stl")) &&
                     MeasureFile("torus", slicing::ToBinaryStl(slicing::TorusMesh(torus)));
  return least && sound ? 0 : 1;
}

}  // namespace slicefarm::bench
