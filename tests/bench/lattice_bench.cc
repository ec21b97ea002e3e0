#include <sys/resource.h>

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "common/stage/exposure_job.h"
#include "services/exposure/algo/local_exposure_stage.h"
#include "tests/bench/benchmarks.h"
#include "tests/bench/lattice.h"
#include "tests/bench/thread_seconds.h"

namespace slicefarm::bench {
namespace {

constexpr int32_t kLayers = 1000;
constexpr int kCells = 117;          ///< a million vectors per layer
constexpr int32_t kRangeLayers = 8;  ///< layers per range for a worker, for layers of this size

double PeakMb() {
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

struct Totals {
  double seconds = 0;
  double megabytes = 0;
  int64_t vectors = 0;
};

/// Exposes and writes a range as a worker does, and discards the result.
absl::Status AddRange(const ExposureStage& stage, int32_t first, const ExposureSettings& settings,
                      Totals& totals) {
  std::vector<SlicedLayer> layers;
  for (int32_t i = 0; i < kRangeLayers; ++i)
    layers.push_back(LatticeLayer(first + i, kLayers, kCells));
  const Shared<ExposureJob> job = ExposureJob{settings, std::vector<Copy>(1)};
  const double start = ThreadSeconds();
  const auto programs = stage.Expose({}, {{first, first + kRangeLayers}, layers}, job);
  totals.seconds += ThreadSeconds() - start;
  if (!programs.ok()) return programs.status();
  for (const ExposedProgram& program : *programs) {
    totals.vectors += program.report.Total().vectors;
    totals.megabytes += 1e-6 * static_cast<double>(program.text.size());
  }
  return absl::OkStatus();
}

}  // namespace

int BenchLattice() {
  ExposureSettings settings;
  settings.regions[0].strategy = ScanStrategy::kHatch;
  settings.output.format = OutputFormat::kCliBinary;
  const auto stage = exposure::MakeLocalExposure();
  Totals totals;
  for (int32_t first = 0; first < kLayers; first += kRangeLayers) {
    const absl::Status status = AddRange(*stage, first, settings, totals);
    if (!status.ok()) {
      std::printf("failed: %s\n", std::string(status.message()).c_str());
      return 1;
    }
    // Bars are thickest at layer 5, so the first range already needs the peak memory.
    if (first == 0) std::printf("lattice_first_range_peak_mb %.0f\n", PeakMb());
  }
  std::printf(
      "lattice_layers %d\nlattice_vectors %lld\nlattice_vectors_per_layer %.0f\n"
      "lattice_cpu_s %.1f\nlattice_million_vectors_per_s %.2f\nlattice_cli_mb %.0f\n"
      "lattice_peak_mb %.0f\n",
      kLayers, static_cast<long long>(totals.vectors),
      static_cast<double>(totals.vectors) / kLayers, totals.seconds,
      1e-6 * static_cast<double>(totals.vectors) / totals.seconds, totals.megabytes, PeakMb());
  return 0;
}

}  // namespace slicefarm::bench
