#include "services/coordinator/server/messages/job_request.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <utility>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/text.h"
#include "common/config/machine_named.h"
#include "common/model/limits.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm::coordinator {
namespace {

absl::Status CheckText(const std::string& field, const std::string& text) {
  if (ReplaceControls(text, '?') == text) return absl::OkStatus();
  return Malformed(field, "has control characters");
}

absl::Status CheckName(const std::string& field, const std::string& name) {
  if (std::ssize(name) > limits::kMaxNameBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of an object's name", limits::kMaxNameBytes,
                      std::ssize(name));
  }
  // Names appear in G-code comments, where a line end would begin a command.
  return CheckText(field, name);
}

absl::Status CheckNames(const SceneObject& object, size_t index) {
  if (absl::Status ok = CheckName(fmt::format("objects[{}].name", index), object.name); !ok.ok())
    return ok;
  for (size_t i = 0; i < object.parts.size(); ++i) {
    const absl::Status ok =
        CheckName(fmt::format("objects[{}].parts[{}].name", index, i), object.parts[i].name);
    if (!ok.ok()) return ok;
  }
  return absl::OkStatus();
}

/// Checks the notes of a project. They become warnings in events and lists of jobs.
absl::Status CheckNotes(const JobRequest& request) {
  constexpr int64_t kMostBytes = 64 << 10;
  int64_t bytes = 0;
  const auto check = [&](const std::string& text) {
    bytes += std::ssize(text);
    return CheckText("notes", text);
  };
  for (const std::string& text : request.warnings)
    if (absl::Status ok = check(text); !ok.ok()) return ok;
  for (const config::MissingFeature& each : request.missing)
    if (absl::Status ok = check(each.text + each.feature); !ok.ok()) return ok;
  if (bytes <= kMostBytes) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "bytes of a job's notes", kMostBytes, bytes);
}

/// Appends all data that determines the result. Arbitrary texts are written with their length,
/// numbers with all their bits.
class ActionWriter {
 public:
  explicit ActionWriter(std::string& text) : out_(text) {}

  void Add(const SubmittedScene& scene) {
    for (const StoredMesh& mesh : scene.meshes) {
      Out("mesh {} {} ", mesh.sha256, static_cast<int>(mesh.format));
      Text(mesh.name);
    }
    for (const SceneObject& object : scene.objects) Add(object);
  }

  void Add(const CalibrationTable& table) {
    if (table == CalibrationTable()) return;
    Out("calibration ");
    for (const std::string* text : {&table.kind, &table.unit, &table.setting}) Text(*text);
    for (const CalibrationRow& row : table.rows) {
      Out("value {:a} {:a} {:a} ", row.value, row.from_mm, row.to_mm);
      Text(row.label);
      Text(row.object);
    }
  }

 private:
  void Add(const SceneObject& object) {
    Out("object ");
    Text(object.name);
    Add(object.settings);
    for (const Part& part : object.parts) Add(part);
    for (const HeightRange& range : object.ranges) {
      Out("range {:a} {:a}\n", range.from_mm, range.to_mm);
      Add(range.settings);
    }
    for (const Instance& instance : object.instances) {
      Out("copy {:d}{:d}{:d}", instance.printable, instance.placed, instance.by_middle);
      Add(instance.to_plate);
    }
  }

  void Add(const Part& part) {
    const MeshRef& mesh = part.mesh;
    Out("part {} {} {} {} {} ", static_cast<int>(part.role), mesh.file, mesh.mesh,
        mesh.first_triangle, mesh.triangle_count);
    Text(part.name);
    Add(part.to_object);
    Add(part.settings);
  }

  void Add(const Transform& transform) {
    for (int i = 0; i < 12; ++i) Out(" {:a}", transform(i / 4, i % 4));
    Out("\n");
  }

  void Add(const std::vector<Setting>& settings) {
    for (const Setting& setting : settings) {
      Out("own {} ", static_cast<int>(setting.source));
      Text(setting.key);
      Text(setting.value);
    }
  }

  void Text(const std::string& text) { Out("{}:{}\n", text.size(), text); }

  template <typename... Args>
  void Out(fmt::format_string<Args...> format, Args&&... args) {
    out_ += fmt::format(format, std::forward<Args>(args)...);
  }

  std::string& out_;
};

/// Returns the text of all data that determines the result.
std::string ActionText(const JobRequest& request, const config::ResolvedPlate& settings,
                       std::string_view build_id, std::string_view result_tenant) {
  std::string text = fmt::format("build {}\n", build_id);
  if (!result_tenant.empty()) text += fmt::format("tenant {}\n", result_tenant);
  ActionWriter(text).Add(request.scene);
  text += settings.effective_text;
  // The report lists these settings, so they belong to the result as well.
  for (const std::string& line : config::TextsOf(settings.no_effect)) {
    text += fmt::format("unused {}:{}\n", line.size(), line);
  }
  // The report also lists warnings that do not follow from the settings.
  for (const std::string& line : request.warnings)
    text += fmt::format("warning {}:{}\n", line.size(), line);
  for (const config::MissingFeature& each : settings.missing)
    text += fmt::format("missing {}:{}\n", each.text.size(), each.text);
  for (const SettingSource& each : request.sources) {
    text += fmt::format("source {}:{}\n", each.source.size(), each.source);
    for (const std::string& key : each.keys) text += fmt::format("key {}:{}\n", key.size(), key);
  }
  ActionWriter(text).Add(request.calibration);
  return text;
}

/// Checks texts and numbers, which the report shows.
absl::Status CheckCalibration(const CalibrationTable& table) {
  constexpr int64_t kMostValues = 1000;
  if (std::ssize(table.rows) > kMostValues)
    return LimitError(Reason::kRequestTooLarge, "values of a calibration print", kMostValues,
                      std::ssize(table.rows));
  std::string texts = table.kind + table.unit + table.setting;
  for (const CalibrationRow& row : table.rows) {
    texts += row.label + row.object;
    if (!std::isfinite(row.value) || !std::isfinite(row.from_mm) || !std::isfinite(row.to_mm))
      return Malformed("calibration", "has a number that is not finite");
  }
  return CheckText("calibration", texts);
}

}  // namespace

absl::Status CheckRequest(const JobRequest& request) {
  const std::vector<SceneObject>& objects = request.scene.objects;
  if (objects.empty()) return Malformed("objects", "are missing: a job has at least one");
  int64_t copies = 0;
  for (size_t i = 0; i < objects.size(); ++i) {
    if (absl::Status ok = CheckNames(objects[i], i); !ok.ok()) return ok;
    copies += std::ssize(objects[i].instances);
  }
  for (const std::string& text : request.without_effect)
    if (absl::Status ok = CheckText("without_effect", text); !ok.ok()) return ok;
  if (absl::Status ok = CheckNotes(request); !ok.ok()) return ok;
  for (const SettingSource& each : request.sources)
    if (absl::Status ok = CheckText("setting_sources", each.source); !ok.ok()) return ok;
  if (absl::Status ok = CheckCalibration(request.calibration); !ok.ok()) return ok;
  if (copies <= limits::kMaxObjects) return absl::OkStatus();
  return LimitError(Reason::kRequestTooLarge, "objects with their copies", limits::kMaxObjects,
                    copies);
}

absl::Status CheckLabels(const std::map<std::string, std::string>& labels) {
  if (std::ssize(labels) > limits::kMaxLabels) {
    return LimitError(Reason::kRequestTooLarge, "labels", limits::kMaxLabels, std::ssize(labels));
  }
  for (const auto& [key, value] : labels) {
    const auto bytes = static_cast<int64_t>(key.size() + value.size());
    if (bytes > limits::kMaxLabelBytes) {
      return LimitError(Reason::kRequestTooLarge, "bytes of a label", limits::kMaxLabelBytes,
                        bytes);
    }
    // Other programs display labels, and some databases cannot store a NUL in a text.
    if (absl::Status ok = CheckText("labels", key + value); !ok.ok()) return ok;
  }
  return absl::OkStatus();
}

absl::Status CheckRequestId(const std::string& request_id) {
  const auto bytes = static_cast<int64_t>(request_id.size());
  if (bytes > limits::kMaxNameBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of request_id", limits::kMaxNameBytes,
                      bytes);
  }
  return CheckText("request_id", request_id);
}

absl::Status CheckAcceptable(const ResolvedJob& job) {
  const JobRequest& request = job.request;
  if (absl::Status ok = config::CheckAllowed(request.allowed); !ok.ok()) return ok;
  if (!request.generic) {
    const absl::Status named = config::CheckMachineNamed(request.settings, request.process);
    if (!named.ok()) return named;
  }
  return config::CheckMissing(job.plate.missing, request.allowed);
}

absl::StatusOr<ResolvedJob> ResolveJob(JobRequest request, std::string_view build_id,
                                       std::string_view result_tenant, const CancelToken& cancel) {
  if (absl::Status ok = CheckRequest(request); !ok.ok()) return ok;
  ResolvedJob job;
  auto settings =
      config::ResolvePlate(request.settings, request.scene.objects, request.process, cancel);
  if (!settings.ok()) return settings.status();
  config::PutInFront(request.without_effect, settings->no_effect);
  std::ranges::copy(request.warnings, std::back_inserter(settings->warnings));
  for (const config::MissingFeature& each : request.missing) {
    settings->missing.push_back(each);
    settings->warnings.push_back(each.text);
  }
  job.settings_digest = Sha256Hex(settings->effective_text);
  job.action_digest = Sha256Hex(ActionText(request, *settings, build_id, result_tenant));
  job.serving_actions = {job.action_digest};
  if (request.mode == JobMode::kQuote) {
    job.action_digest = Sha256Hex("quote of " + job.action_digest);
    job.serving_actions.push_back(job.action_digest);
  }
  job.request = std::move(request);
  job.plate = *std::move(settings);
  return job;
}

}  // namespace slicefarm::coordinator
