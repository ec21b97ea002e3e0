#include "services/cli/console/console.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "common/base/duration_text.h"
#include "common/base/error.h"
#include "common/config/missing_feature.h"
#include "common/config/table/settings_table.h"
#include "common/model/process.h"

namespace slicefarm::cli {

namespace {

/// Returns the `slicefarm settings` command that shows a setting; empty if no process has it.
std::string HowToShow(std::string_view key) {
  for (const ProcessInfo& info : kProcesses) {
    if (config::FindSetting(key, info.process) < 0) continue;
    const bool other = info.process != kDefaultProcess;
    return fmt::format("slicefarm settings {}{}{}", key, other ? " --machine " : "",
                       other ? info.name : "");
  }
  return "";
}

/// Returns advice on the value of a setting. `detail`: detail of an error about this value.
std::string AdviceOnValue(const ErrorDetail& detail) {
  const auto setting = detail.metadata.find("setting");
  if (setting == detail.metadata.end()) return "";
  const std::string how = HowToShow(setting->second);
  if (how.empty()) return "";
  return fmt::format("`{}` explains the setting; --set {}=VALUE replaces its value", how,
                     setting->second);
}

std::string AdviceOnFeature(const ErrorDetail& detail) {
  const auto allow = detail.metadata.find("allow");
  if (allow == detail.metadata.end()) return AdviceOnValue(detail);
  const bool tools = allow->second == config::kSeveralTools;
  return fmt::format(
      "{}--allow {} makes the job without this feature, with a warning",
      tools ? "give all objects the same extruder, or print them as separate jobs; " : "",
      allow->second);
}

}  // namespace

std::string Advice(const absl::Status& status) {
  if (absl::IsUnimplemented(status))
    return "check that a coordinator of this version runs at the address in --server";
  const ErrorDetail detail = DetailOf(status);
  switch (detail.reason) {
    case Reason::kSettingUnknown:
    case Reason::kSettingMisplaced:
      return "`slicefarm settings [--machine MACHINE]` lists every setting with its range";
    case Reason::kSettingMalformed:
    case Reason::kSettingOutOfRange:
      return AdviceOnValue(detail);
    case Reason::kNotSupported:
      return AdviceOnFeature(detail);
    case Reason::kPrinterMissing:
      return "name the printer with --profile NAME (see `slicefarm profile list`) or --config "
             "FILE, or add --generic for no particular printer";
    case Reason::kRequestMalformed:
      return detail.metadata.contains("plates")
                 ? "choose a plate with --plate N, or make a job of each plate with --plates"
                 : "";
    case Reason::kMeshFormatUnknown:
      return "give an STL (binary or ASCII), OBJ, PLY or 3MF file";
    case Reason::kMeshEmpty:
      return "check that the file contains a model; a sliced export (.gcode.3mf) may contain "
             "G-code only";
    case Reason::kMeshTruncated:
      return "the file is incomplete: export or download it again";
    case Reason::kOutOfRange:
    case Reason::kOutOfBuildVolume:
      return "use --scale or --rotate, or another bed_shape or max_print_height. If the "
             "coordinates in the file are not in mm, use --units. If the copies do not fit on one "
             "bed, use --plates";
    case Reason::kNothingToPrint:
      return "the model may be empty or much smaller than a layer; if its coordinates are not in "
             "mm, give their unit with --units";
    case Reason::kUnavailable:
      return "check that the coordinator runs at the address in --server: `slicefarm health "
             "HOST:PORT`";
    case Reason::kDeadlineExceeded:
      return detail.metadata.contains("field")  // deadline of a job, not of a call
                 ? "submit the job again with a later --deadline, or with a higher --priority"
                 : "the server is too busy, or the network too slow: try again";
    case Reason::kOverloaded:
    case Reason::kQueueFull:
    case Reason::kDiskLow:
      return "the farm accepted no more jobs during the time of --patience: try again later, or "
             "with a larger --patience";
    case Reason::kJobNotFound:
      return "`slicefarm list` shows the existing jobs";
    case Reason::kJobNotFinished:
      return "`slicefarm watch JOB` waits until the job has ended";
    case Reason::kInternal:
      return absl::IsDataLoss(status) ? ""
                                      : "this is an internal error of slicefarm; please report it";
    default:
      return "";
  }
}

ExitCode Fail(const absl::Status& status) {
  fmt::print(stderr, "error: {}\n", std::string(status.message()));
  const std::string advice = Advice(status);
  if (!advice.empty()) fmt::print(stderr, "       {}\n", advice);
  return ExitCodeOf(status);
}

void Warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) fmt::print(stderr, "warning: {}\n", warning);
}

void WarnOfRest(std::vector<std::string> warnings, const std::vector<std::string>& reported) {
  std::erase_if(warnings, [&reported](const std::string& warning) {
    return std::ranges::find(reported, warning) != reported.end();
  });
  Warn(warnings);
}

void Print(std::string_view text, bool to_stderr) {
  std::FILE* out = to_stderr ? stderr : stdout;
  std::fwrite(text.data(), 1, text.size(), out);
  std::fflush(out);
}

ProgressBar::ProgressBar(bool wanted) : enabled_(wanted && isatty(STDERR_FILENO) != 0) {}

void ProgressBar::Show(std::string_view what, int done, int total) {
  if (!enabled_) return;
  constexpr int kWidth = 30;
  std::string line;
  if (total > 0) {
    const int filled = kWidth * std::clamp(done, 0, total) / total;
    line = fmt::format("{:<12} [{}{}] {}/{}{}", what, std::string(filled, '#'),
                       std::string(kWidth - filled, ' '), done, total, TimeLeft(what, done, total));
  } else {
    line = fmt::format("{} ...", what);
  }
  if (line == line_) return;
  line_ = std::move(line);
  shown_ = true;
  fmt::print(stderr, "\r\x1b[K{}", line_);
  std::fflush(stderr);
}

/// Returns ", 12s left", estimated from the speed so far; empty if it is not known.
std::string ProgressBar::TimeLeft(std::string_view what, int done, int total) {
  if (what != what_) {
    what_ = what;
    first_done_ = done;
    since_ = Stopwatch();
  }
  constexpr double kSoonestS = 2;
  const double seconds = since_.Seconds();
  if (done <= first_done_ || done >= total || seconds < kSoonestS) return "";
  return fmt::format(", {} left", DurationText(seconds * (total - done) / (done - first_done_)));
}

void ProgressBar::Clear() {
  if (!shown_) return;
  shown_ = false;
  line_.clear();
  fmt::print(stderr, "\r\x1b[K");
  std::fflush(stderr);
}

}  // namespace slicefarm::cli
