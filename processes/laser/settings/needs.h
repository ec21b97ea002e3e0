#pragma once

#include "common/config/table/need.h"
#include "processes/laser/model/exposure_options.h"
#include "processes/laser/model/exposure_settings.h"

namespace slicefarm::config::laser::needs {

inline bool IsRings(const JobRows& s) {
  const ScanStrategy strategy = ExposureOf(s).region.strategy;
  return strategy == ScanStrategy::kRings || strategy == ScanStrategy::kRingsInward;
}
inline bool IsHatched(const JobRows& s) { return !IsRings(s); }
inline bool IsGcode(const JobRows& s) {
  const OutputFormat format = ExposureOf(s).output.format;
  return format == OutputFormat::kGrbl || format == OutputFormat::kMarlin;
}
inline bool IsCli(const JobRows& s) {
  const OutputFormat format = ExposureOf(s).output.format;
  return format == OutputFormat::kCliAscii || format == OutputFormat::kCliBinary;
}
inline bool HasContours(const JobRows& s) { return ExposureOf(s).region.contours > 0; }

inline constexpr Need kRings{"scan_strategy = rings or rings_inward", IsRings};
inline constexpr Need kHatched{"scan_strategy = stripes, islands or hatch", IsHatched};
inline constexpr Need kGasDirection{
    "gas_window above 0, or jump_order = against_gas", [](const JobRows& s) {
      const ExposureOptions& region = ExposureOf(s).region;
      return region.gas_window_deg > 0 || region.jump_order == JumpOrder::kAgainstGas;
    }};
inline constexpr Need kStripes{"scan_strategy = stripes", [](const JobRows& s) {
                                 return ExposureOf(s).region.strategy == ScanStrategy::kStripes;
                               }};
inline constexpr Need kIslands{"scan_strategy = islands", [](const JobRows& s) {
                                 return ExposureOf(s).region.strategy == ScanStrategy::kIslands;
                               }};
inline constexpr Need kCells{"scan_strategy = stripes or islands", [](const JobRows& s) {
                               const ScanStrategy strategy = ExposureOf(s).region.strategy;
                               return strategy == ScanStrategy::kStripes ||
                                      strategy == ScanStrategy::kIslands;
                             }};
inline constexpr Need kContoursOfHatch{
    "scan_strategy = stripes, islands or hatch, and contours above 0",
    [](const JobRows& s) { return HasContours(s) && !IsRings(s); }};
inline constexpr Need kContours{"contours above 0", HasContours};
inline constexpr Need kContoursOrThinWalls{
    "contours above 0, or thin_wall_exposure = 1",
    [](const JobRows& s) { return HasContours(s) || ExposureOf(s).region.thin_walls; }};
inline constexpr Need kSecondContour{
    "contours above 1, or contours = 1 with rings",
    [](const JobRows& s) { return ExposureOf(s).region.contours > (IsRings(s) ? 0 : 1); }};
inline constexpr Need kSkins{"upskin_layers or downskin_layers above 0", [](const JobRows& s) {
                               const ExposureOptions& region = ExposureOf(s).region;
                               return region.upskin_layers > 0 || region.downskin_layers > 0;
                             }};
inline constexpr Need kUpskins{"upskin_layers above 0", [](const JobRows& s) {
                                 return ExposureOf(s).region.upskin_layers > 0;
                               }};
inline constexpr Need kDownskins{"downskin_layers above 0", [](const JobRows& s) {
                                   return ExposureOf(s).region.downskin_layers > 0;
                                 }};
inline constexpr Need kThinWalls{"thin_wall_exposure = 1",
                                 [](const JobRows& s) { return ExposureOf(s).region.thin_walls; }};
inline constexpr Need kPulsesInFile{
    "output_format = cli or cli_binary, otherwise only the report uses it", IsCli};
inline constexpr Need kStylesInFile{
    "output_format = cli, cli_binary, grbl or marlin, otherwise only the report uses it",
    [](const JobRows& s) { return IsCli(s) || IsGcode(s); }};
inline constexpr Need kDelaysInFile{
    "output_format = grbl or marlin, otherwise only the report uses it", IsGcode};
inline constexpr Need kJumpSpeedInFile{
    "output_format = marlin, otherwise only the report uses it",
    [](const JobRows& s) { return ExposureOf(s).output.format == OutputFormat::kMarlin; }};
inline constexpr Need kDxf{"output_format = dxf", [](const JobRows& s) {
                             return ExposureOf(s).output.format == OutputFormat::kDxf;
                           }};
inline constexpr Need kCli{"output_format = cli or cli_binary", IsCli};
inline constexpr Need kGcode{"output_format = grbl or marlin", IsGcode};

}  // namespace slicefarm::config::laser::needs
