#include "services/coordinator/server/api/job_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "common/base/error.h"
#include "common/model/limits.h"
#include "common/base/sha256.h"
#include "common/base/text.h"
#include "common/wire/wire_error.h"

namespace slicefarm::coordinator {
namespace {

absl::Status CheckText(const std::string& field, const std::string& text) {
  if (ReplaceControls(text, '?') == text) return absl::OkStatus();
  return Malformed(field, "has control characters");
}

absl::Status CheckObject(const ObjectRequest& object, size_t index) {
  const auto field = [index](const char* name) {
    return fmt::format("objects[{}].{}", index, name);
  };
  if (!IsSha256Hex(object.mesh_sha256)) {
    return Malformed(field("mesh_sha256"), "is not a SHA-256, 64 lower-case hex digits");
  }
  if (object.copies < 0) return Malformed(field("copies"), "are negative");
  if (absl::Status ok = CheckPlacement(object.placement); !ok.ok()) return ok;
  const auto name_bytes = static_cast<int64_t>(object.name.size());
  if (name_bytes > limits::kMaxNameBytes) {
    return LimitError(Reason::kRequestTooLarge, "bytes of an object's name", limits::kMaxNameBytes,
                      name_bytes);
  }
  // Names end up in G-code comments, where a line end would begin a command.
  return CheckText(field("name"), object.name);
}

int64_t CopiesOf(const ObjectRequest& object) {
  const auto centers = std::ssize(object.placement.centers);
  return std::max<int64_t>({1, centers, object.copies});
}

/// The meshes of the objects, each once, and the objects as they stand on the plate.
std::vector<SceneObject> SceneOf(const JobRequest& request, std::vector<MeshRequest>& meshes) {
  std::map<std::pair<std::string, MeshFormat>, int32_t> known;
  std::vector<SceneObject> scene;
  for (const ObjectRequest& object : request.objects) {
    const auto [mesh, is_new] = known.try_emplace({object.mesh_sha256, object.format},
                                                  static_cast<int32_t>(meshes.size()));
    if (is_new) meshes.push_back({object.mesh_sha256, object.name, object.format});
    scene.push_back(ObjectOfFile(object.name, mesh->second, object.placement, object.copies));
    scene.back().settings = object.settings;
  }
  return scene;
}

/// The text of all that decides the result. Texts that may hold anything come with their length.
std::string ActionText(const JobRequest& request, const config::ResolvedPlate& settings,
                       std::string_view build_id, std::string_view result_tenant) {
  std::string text = fmt::format("build {}\n", build_id);
  auto out = std::back_inserter(text);
  if (!result_tenant.empty()) fmt::format_to(out, "tenant {}\n", result_tenant);
  for (const ObjectRequest& object : request.objects) {
    const Placement& p = object.placement;
    fmt::format_to(out, "object {} {} {}:{}\n", object.mesh_sha256, static_cast<int>(object.format),
                   object.name.size(), object.name);
    fmt::format_to(out, "placed {:a} {:a} {:a} {:a} {:a} {:a} {:a}", p.unit_mm, p.scale[0],
                   p.scale[1], p.scale[2], p.rotate_deg[0], p.rotate_deg[1], p.rotate_deg[2]);
    for (const Point center : p.centers) fmt::format_to(out, " {} {}", center.x, center.y);
    fmt::format_to(out, "\ncopies {}\n", object.copies);
    for (const Setting& setting : object.settings)
      fmt::format_to(out, "own {}:{} {}:{}\n", setting.key.size(), setting.key,
                     setting.value.size(), setting.value);
  }
  text += settings.effective_text;
  // The report names these, so they belong to the result as well.
  for (const std::string& line : settings.no_effect) {
    fmt::format_to(out, "unused {}:{}\n", line.size(), line);
  }
  return text;
}

}  // namespace

absl::Status CheckRequest(const JobRequest& request) {
  if (request.objects.empty()) return Malformed("objects", "are missing: a job has at least one");
  int64_t copies = 0;
  for (size_t i = 0; i < request.objects.size(); ++i) {
    if (absl::Status ok = CheckObject(request.objects[i], i); !ok.ok()) return ok;
    copies += CopiesOf(request.objects[i]);
  }
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
    // They are shown by others, and not every database keeps a NUL in a text.
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

absl::StatusOr<ResolvedJob> ResolveJob(JobRequest request, std::string_view build_id,
                                       std::string_view result_tenant) {
  if (absl::Status ok = CheckRequest(request); !ok.ok()) return ok;
  ResolvedJob job;
  const std::vector<SceneObject> scene = SceneOf(request, job.meshes);
  auto settings = config::ResolvePlate(request.settings, scene);
  if (!settings.ok()) return settings.status();
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
