#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/base/error.h"
#include "services/cli/commands/commands.h"
#include "services/cli/commands/gcode_options.h"
#include "services/cli/console/choice_option.h"
#include "services/cli/console/console.h"
#include "services/cli/console/files.h"
#include "services/cli/program/machine_config.h"
#include "services/cli/render/cli_layer.h"
#include "services/cli/render/gcode_reader.h"
#include "services/cli/render/layer_drawing.h"
#include "services/cli/render/mill_layer.h"
#include "services/motion/algo/program/program_time.h"

namespace slicefarm::cli {
namespace {

constexpr int64_t kMostRenderedBytes = int64_t{4} << 30;

struct RenderOptions {
  std::string gcode;
  std::string output;
  std::optional<int> layer;
  std::string format;
  ColourBy colour_by = ColourBy::kFeature;
  double spot_mm = 0.08;
  int size_px = 1200;
  bool travels = false;
  std::string flavor;
  int plate = 0;  ///< number of the plate in an archive; 0: the only one
};

/// Returns the format from --format, or else from the end of the output's name.
absl::StatusOr<ImageFormat> FormatOf(const RenderOptions& options) {
  const std::string name = "." + options.format;
  const std::string_view end = options.format.empty() ? options.output : name;
  if (end.ends_with(".svg")) return ImageFormat::kSvg;
  if (end.ends_with(".png")) return ImageFormat::kPng;
  return MakeError(absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
                   fmt::format("{}: the name does not show the format of the picture: use a name "
                               "that ends in .png or .svg, or add --format",
                               options.output));
}

/// Returns the firmware from --flavor, or else the one that the file quotes, or else Marlin.
absl::StatusOr<const motion::Firmware*> FirmwareFor(const RenderOptions& options,
                                                    std::string_view gcode) {
  if (options.flavor.empty())
    if (const motion::Firmware* named = FirmwareNamedIn(gcode)) return named;
  if (const motion::Firmware* found =
          motion::FindFirmware(options.flavor.empty() ? "marlin" : options.flavor))
    return found;
  return UnknownFlavor(options.flavor);
}

/// Reads the beads of a layer. If the colours show the time, each bead has its time.
absl::StatusOr<GcodeLayer> ReadLayer(const RenderOptions& options, std::string_view gcode) {
  if (options.colour_by != ColourBy::kTime) return ReadGcodeLayer(gcode, *options.layer);
  const auto firmware = FirmwareFor(options, gcode);
  if (!firmware.ok()) return firmware.status();
  const auto machine = ReadMachine("", gcode);
  if (!machine.ok()) return machine.status();
  const motion::ProgramTime time = motion::TimeOfProgram(gcode, **firmware, machine->setup.machine);
  return ReadGcodeLayer(gcode, *options.layer, time.line_end_s);
}

/// Reads one level or all levels of a milling program, and one layer of any other file.
absl::StatusOr<GcodeLayer> ReadAny(const RenderOptions& options, std::string_view gcode) {
  if (IsMillProgram(gcode)) return ReadMillLayer(gcode, options.layer);
  if (!options.layer)
    return MakeError(
        absl::StatusCode::kInvalidArgument, Reason::kRequestMalformed,
        "--layer is needed for this file: only milling programs can be drawn as a whole");
  if (IsCliFile(gcode)) return ReadCliLayer(gcode, *options.layer, options.spot_mm);
  return ReadLayer(options, gcode);
}

ExitCode Render(const RenderOptions& options) {
  const auto format = FormatOf(options);
  if (!format.ok()) return Fail(format.status());
  const auto gcode = ReadText(options.gcode, kMostRenderedBytes, options.plate);
  if (!gcode.ok()) return Fail(gcode.status());
  const auto layer = ReadAny(options, *gcode);
  if (!layer.ok()) return Fail(layer.status());
  const auto image = DrawLayer(*layer, {.format = *format,
                                        .colour_by = options.colour_by,
                                        .size_px = options.size_px,
                                        .travels = options.travels});
  if (!image.ok()) return Fail(image.status());
  if (absl::Status status = WriteFile(options.output, *image); !status.ok()) return Fail(status);
  return ExitCode::kOk;
}

}  // namespace

void AddRender(CLI::App& app, CommandContext& context) {
  CLI::App* command = app.add_subcommand("render",
                                         "Draw a layer of a G-code file, of a CLI file (Common "
                                         "Layer Interface) or of a milling program");
  const auto options = std::make_shared<RenderOptions>();
  command
      ->add_option(
          "GCODE", options->gcode,
          "G-code by slicefarm or PrusaSlicer (text, .bgcode or .gcode.3mf), or a CLI file")
      ->required();
  AddPlateOption(*command, options->plate);
  command
      ->add_option("-l,--layer", options->layer,
                   "Layer to draw, counted from 0. Milling programs: level to draw, counted from "
                   "the top; without -l, all toolpaths")
      ->check(ZeroOrMore())
      ->type_name("N");
  command->add_option("-o,--output", options->output, "File for the picture; -: to stdout")
      ->required()
      ->type_name("LAYER.png|svg");
  command
      ->add_option("--format", options->format,
                   "Format of the picture; default: by the ending of the output's name")
      ->check(OneOf(std::vector<std::string>{"png", "svg"}));
  command
      ->add_option("--color,--by", options->colour_by,
                   "Property that the colours show: feature (the default), width, speed, flow, "
                   "time, order or energy. time: when a line is printed, estimated for the "
                   "firmware --flavor. energy: in J/mm2 if the labels of a CLI file give power and "
                   "speed, otherwise the number of passes")
      ->transform(OneOf(std::map<std::string, ColourBy>{{"feature", ColourBy::kFeature},
                                                        {"width", ColourBy::kWidth},
                                                        {"speed", ColourBy::kSpeed},
                                                        {"flow", ColourBy::kFlow},
                                                        {"time", ColourBy::kTime},
                                                        {"order", ColourBy::kOrder},
                                                        {"energy", ColourBy::kEnergy}}))
      ->type_name("WHAT");
  command
      ->add_option("--flavor", options->flavor,
                   "Firmware for which times are estimated; default: the firmware that the file "
                   "names, otherwise marlin")
      ->type_name("NAME");
  command
      ->add_option(
          "--spot", options->spot_mm,
          "Width of the drawn lines of a CLI file, in mm, because such files contain no widths")
      ->check(InRange(0.001, 10.0))
      ->capture_default_str()
      ->type_name("MM");
  command->add_option("--size", options->size_px, "Longer side of the picture, in pixels")
      ->check(InRange(50, 8000))
      ->capture_default_str()
      ->type_name("PX");
  command->add_flag("--travels", options->travels, "Draw travels too, as thin lines");
  command->footer(
      "Lines are drawn in printing order, with their true width and round ends.\nExample:\n  "
      "slicefarm render part.gcode --layer 12 -o layer.png\n  slicefarm render part.cli --layer 12 "
      "-o order.png --color order\n  slicefarm render part.nc -o toolpaths.png");
  command->callback([options, &context] { context.run = [options] { return Render(*options); }; });
}

}  // namespace slicefarm::cli
