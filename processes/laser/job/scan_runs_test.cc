#include "processes/laser/job/scan_runs.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "common/base/error.h"
#include "common/geometry/text_format_test.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::coordinator::scan_runs_test {
namespace {

/// A bed of 100 mm.
struct Plate {
  explicit Plate(const char* outline) {
    bed = {{0, 0}, {FromMm(100), 0}, {FromMm(100), FromMm(100)}, {0, FromMm(100)}};
    layers.resize(2);
    layers[1].sections.emplace_back().regions.push_back({.outlines = MakePolygonsOrDie(outline)});
  }
  /// Returns the setting that the error names; empty: no error.
  std::string Fault(std::vector<Point> places) const {
    std::vector<PlacedCopy> copies;
    for (const Point place : places) copies.push_back({0, place, {}});
    const absl::Status status = CheckRuns(settings, bed, SlicedOutlines{layers, copies});
    if (status.ok()) return "";
    EXPECT_EQ(DetailOf(status).reason, Reason::kOutOfBuildVolume);
    return DetailOf(status).metadata.at("setting");
  }
  ExposureOptions& options() { return settings.regions[0]; }

  ExposureSettings settings;
  Polygon bed;
  std::vector<SlicedLayer> layers;
};

TEST(CheckRuns, WhatIsExposedLiesAsFarFromTheEdgeAsTheRun) {
  Plate plate("(-5 -5, 5 -5, 5 5, -5 5)");
  const Point middle{FromMm(50), FromMm(50)}, side{FromMm(7), FromMm(50)};
  EXPECT_EQ(plate.Fault({middle, side}), "");
  plate.options().skywriting_nm = FromMm(2.04);  // the contour is 0.04 mm inside the outline
  EXPECT_EQ(plate.Fault({middle, side}), "");
  plate.options().skywriting_nm += 1;
  EXPECT_EQ(plate.Fault({middle}), "");
  EXPECT_EQ(plate.Fault({middle, side}), "skywriting");
  plate.options().strategy = ScanStrategy::kRings;  // rings have no such runs
  EXPECT_EQ(plate.Fault({middle, side}), "");
  plate.options().contour_run_nm = FromMm(2.041);
  EXPECT_EQ(plate.Fault({middle, side}), "contour_run");
}

/// The contour of a sharp tip ends far inside the tip.
TEST(CheckRuns, TipsMayBeNearer) {
  Plate plate("(0 0, 20 -1, 20 1)");
  plate.options().skywriting_nm = FromMm(2.3);
  EXPECT_EQ(plate.Fault({{FromMm(2), FromMm(50)}}), "");
  EXPECT_EQ(plate.Fault({{FromMm(1), FromMm(50)}}), "skywriting");
}

}  // namespace
}  // namespace slicefarm::coordinator::scan_runs_test
