#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "services/milling/algo/motion/mill_program.h"
#include "services/milling/algo/output/program_text.h"
#include "services/milling/algo/sample_parts_test.h"
#include "services/milling/algo/strategy/mill_steps.h"

namespace slicefarm::milling {

/// Closed part of square pillars side by side: heights[row][column], in mm. All heights are above
/// 0, the height of its bottom. (0, 0) is a corner of the part.
struct Pillars {
  std::vector<std::vector<double>> heights;
  double side = 1;

  double HeightAt(double x, double y) const {
    const double column = std::floor(x / side), row = std::floor(y / side);
    if (column < 0 || row < 0) return 0;
    if (row >= heights.size() || column >= heights[0].size()) return 0;
    return heights[static_cast<size_t>(row)][static_cast<size_t>(column)];
  }

  TriangleMesh Mesh() const {
    std::vector<double> cuts = {0};
    for (const auto& row : heights) cuts.insert(cuts.end(), row.begin(), row.end());
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    TriangleMesh mesh;
    for (size_t row = 0; row < heights.size(); ++row)
      for (size_t column = 0; column < heights[0].size(); ++column)
        AddPillar(static_cast<double>(column), static_cast<double>(row), cuts, mesh);
    return mesh;
  }

 private:
  void AddPillar(double column, double row, const std::vector<double>& cuts,
                 TriangleMesh& mesh) const {
    const double x = column * side, y = row * side, far = side;
    const double h = HeightAt(x + side / 2, y + side / 2);
    AddQuad(mesh, {{{x, y, h}, {x + far, y, h}, {x + far, y + far, h}, {x, y + far, h}}});
    AddQuad(mesh, {{{x, y, 0}, {x, y + far, 0}, {x + far, y + far, 0}, {x + far, y, 0}}});
    const Eigen::Vector2d corners[] = {{x, y}, {x + far, y}, {x + far, y + far}, {x, y + far}};
    const Eigen::Vector2d out[] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}};
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector2d a = corners[k], b = corners[(k + 1) % 4];
      const Eigen::Vector2d beyond = (a + b) / 2 + out[k] * side / 2;
      const double other = HeightAt(beyond.x(), beyond.y());
      for (size_t i = 0; i + 1 < cuts.size(); ++i) {
        if (cuts[i] < other || cuts[i + 1] > h) continue;
        AddQuad(mesh, {{{a.x(), a.y(), cuts[i]},
                        {b.x(), b.y(), cuts[i]},
                        {b.x(), b.y(), cuts[i + 1]},
                        {a.x(), a.y(), cuts[i + 1]}}});
      }
    }
  }
};

/// Returns a plate of 9 x 8 mm with a pocket, an island in the pocket and a step: the main cases of
/// a program.
inline Pillars PocketPart() {
  return {.heights = {{3, 3, 3, 3, 3, 3, 3, 3, 3},
                      {3, 1, 1, 1, 1, 1, 1, 3, 2},
                      {3, 1, 1, 1, 1, 1, 1, 3, 2},
                      {3, 1, 1, 2, 2, 1, 1, 3, 2},
                      {3, 1, 1, 2, 2, 1, 1, 3, 2},
                      {3, 1, 1, 1, 1, 1, 1, 3, 2},
                      {3, 1, 1, 1, 1, 1, 1, 3, 2},
                      {3, 3, 3, 3, 3, 3, 3, 3, 3}}};
}

inline MillingOptions OptionsFor(std::string_view cutter) {
  return MillingOptions{.cutter = CutterOf(cutter)};
}

inline MillingJob JobOf(const TriangleMesh& part, const MillingOptions& options) {
  auto job = PrepareMilling(part, std::nullopt, options);
  EXPECT_TRUE(job.ok()) << job.status();
  return *std::move(job);
}

inline std::vector<MilledStep> AllSteps(const MillingJob& job) {
  auto steps = MillSteps(job, 0, job.steps.size());
  EXPECT_TRUE(steps.ok()) << steps.status();
  return *std::move(steps);
}

inline MillProgram ProgramOf(const MillingJob& job) {
  auto program = AssembleProgram(job, AllSteps(job));
  EXPECT_TRUE(program.ok()) << program.status();
  return *std::move(program);
}

inline std::string TextOf(const MillingJob& job) {
  return ProgramText(ProgramOf(job), job.options, *DialectOf(MillDialect::kLinuxCnc));
}

}  // namespace slicefarm::milling
