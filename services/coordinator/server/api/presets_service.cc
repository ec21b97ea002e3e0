#include "services/coordinator/server/api/presets_service.h"

#include <algorithm>
#include <charconv>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "common/base/error.h"
#include "common/base/sha256.h"
#include "common/base/text.h"
#include "common/base/utf8.h"
#include "common/config/presets/choose_presets.h"
#include "common/config/presets/job_presets.h"
#include "common/model/limits.h"
#include "common/rpc/status_mapping.h"
#include "common/wire/support/wire_error.h"
#include "services/coordinator/server/api/profile_settings.h"
#include "services/coordinator/server/messages/jobs_wire.h"

namespace slicefarm::coordinator {
namespace {

namespace presets = config::presets;

constexpr int kReportedProblems = 100;  // lines of an answer; a set of 8,000 files may have as many
/// Bytes of the files of one bundle. With its name and digest, it must fit into a message.
constexpr int64_t kMaxBundleBytes = limits::kMaxPublicMessageBytes - (64 << 10);
constexpr size_t kProblemBytes = 1'000;
constexpr int32_t kNamesOfPage = 1'000;
constexpr int32_t kMaxNamesOfPage = 10'000;

/// Checks the paths. They are shown to people, and archives within them add names of their own.
absl::Status CheckFiles(const v1::ImportPresetsRequest& request) {
  for (int i = 0; i < request.files_size(); ++i) {
    const std::string& path = request.files(i).path();
    const bool printable = !path.empty() && ReplaceControls(path, '?') == path;
    if (!printable) return Within("files", i, Malformed("path", "is empty or not printable"));
    if (std::ssize(path) > limits::kMaxSettingBytes)
      return LimitError(Reason::kRequestTooLarge, "bytes of a path", limits::kMaxSettingBytes,
                        std::ssize(path));
  }
  return absl::OkStatus();
}

v1::PresetKind KindToProto(presets::PresetKind kind) {
  return static_cast<v1::PresetKind>(static_cast<int>(kind) + 1);
}
static_assert(static_cast<int>(presets::PresetKind::kFilament) + 1 == v1::PRESET_KIND_FILAMENT);

/// Reads the index of the next preset from a page token.
absl::StatusOr<size_t> StartOf(const std::string& token) {
  size_t start = 0;
  if (token.empty()) return start;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), start);
  if (error != std::errc() || end != token.data() + token.size())
    return Malformed("page_token", "is not from an answer of ListPresets");
  return start;
}

}  // namespace

grpc::Status PresetsService::ImportPresets(grpc::ServerContext* context,
                                           const v1::ImportPresetsRequest* request,
                                           v1::PresetBundle* response) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(Import(*caller, *request, response));
}

absl::Status PresetsService::Import(const Caller& caller, const v1::ImportPresetsRequest& request,
                                    v1::PresetBundle* response) {
  if (absl::Status named = CheckProfileName(request.name()); !named.ok()) return named;
  if (absl::Status ok = CheckFiles(request); !ok.ok()) return ok;
  std::string bytes = BundleBytes(request.files());
  if (std::ssize(bytes) > kMaxBundleBytes)
    return LimitError(Reason::kRequestTooLarge, "bytes of a bundle of presets", kMaxBundleBytes,
                      std::ssize(bytes));
  if (absl::Status space = disk_.CheckSpace(std::ssize(bytes)); !space.ok()) return space;
  absl::Status space = budgets_.CheckBytes(caller.tenant, caller.max_kept_bytes, std::ssize(bytes));
  if (!space.ok()) return space;
  v1::PresetBundle given;
  *given.mutable_files() = request.files();
  const auto set = library_.Read(given);
  if (!set.ok()) return set.status();
  const std::string digest = Sha256Hex(bytes);
  const auto record =
      bundles_.Put({caller.tenant, request.name(), std::move(bytes), digest}, now_us_());
  if (!record.ok()) return record.status();
  auto bundle = ReadBundle(*record);
  if (!bundle.ok()) return bundle.status();
  bundle->clear_files();
  bundle->set_presets(static_cast<int32_t>(
      std::ranges::count_if(set->presets(), [](const auto& each) { return each.listed; })));
  for (const std::string& line : set->problems())
    if (bundle->problems_size() < kReportedProblems)
      bundle->add_problems(ToUtf8(line, kProblemBytes));
  *response = *std::move(bundle);
  return absl::OkStatus();
}

grpc::Status PresetsService::GetPresetBundle(grpc::ServerContext* context,
                                             const v1::GetPresetBundleRequest* request,
                                             v1::PresetBundle* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->revision() < 0) return rpc::ToGrpc(Malformed("revision", "is negative"));
  const auto record = bundles_.Get(caller->tenant, request->name(), request->revision());
  if (!record.ok()) return rpc::ToGrpc(record.status());
  auto bundle = ReadBundle(*record);
  if (bundle.ok()) *response = *std::move(bundle);
  return rpc::ToGrpc(bundle.status());
}

grpc::Status PresetsService::ListPresetBundles(grpc::ServerContext* context,
                                               const v1::ListPresetBundlesRequest* request,
                                               v1::ListPresetBundlesResponse* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(ListBundles(caller->tenant, *request, response));
}

absl::Status PresetsService::ListBundles(const std::string& tenant,
                                         const v1::ListPresetBundlesRequest& request,
                                         v1::ListPresetBundlesResponse* response) {
  if (request.page_size() < 0) return Malformed("page_size", "is negative");
  const int32_t limit = request.page_size() == 0
                            ? kDefaultPageSize
                            : std::min(request.page_size(), limits::kMaxPageSize);
  const auto records = bundles_.List(tenant, request.page_token(), limit);
  if (!records.ok()) return records.status();
  for (const ProfileRecord& record : *records) {
    auto bundle = ReadBundle(record);
    if (!bundle.ok()) return bundle.status();
    *response->add_bundles() = *std::move(bundle);
  }
  if (std::ssize(*records) == limit) response->set_next_page_token(records->back().name);
  return absl::OkStatus();
}

grpc::Status PresetsService::DeletePresetBundle(grpc::ServerContext* context,
                                                const v1::DeletePresetBundleRequest* request,
                                                google::protobuf::Empty*) {
  const auto caller = callers_.Find(*context, {Scope::kSubmit});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  if (request->revision() < 0) return rpc::ToGrpc(Malformed("revision", "is negative"));
  const absl::Status deleted =
      bundles_.Delete(caller->tenant, request->name(), request->revision(), now_us_());
  library_.Forget(caller->tenant);
  return rpc::ToGrpc(deleted);
}

grpc::Status PresetsService::ListPresets(grpc::ServerContext* context,
                                         const v1::ListPresetsRequest* request,
                                         v1::ListPresetsResponse* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(ListNames(caller->tenant, *request, response));
}

absl::Status PresetsService::ListNames(const std::string& tenant,
                                       const v1::ListPresetsRequest& request,
                                       v1::ListPresetsResponse* response) {
  if (request.page_size() < 0) return Malformed("page_size", "is negative");
  const auto start = StartOf(request.page_token());
  if (!start.ok()) return start.status();
  const int32_t size =
      request.page_size() == 0 ? kNamesOfPage : std::min(request.page_size(), kMaxNamesOfPage);
  const auto loaded = library_.Load(tenant, {request.bundles().begin(), request.bundles().end()});
  if (!loaded.ok()) return loaded.status();
  const presets::PresetSet& set = (*loaded)->set();
  const auto listed = presets::ListedPresets(set, request.printer());
  if (!listed.ok()) return listed.status();
  const size_t end = std::min(listed->size(), *start + static_cast<size_t>(size));
  for (size_t i = *start; i < end; ++i) {
    const presets::Preset& preset = *(*listed)[i];
    v1::PresetName& name = *response->add_presets();
    name.set_kind(KindToProto(preset.kind));
    name.set_name(preset.name);
    name.set_vendor(set.ScopeOf(preset).vendor);
    name.set_file(preset.file);
  }
  if (end < listed->size()) response->set_next_page_token(std::to_string(end));
  return absl::OkStatus();
}

grpc::Status PresetsService::ResolvePresets(grpc::ServerContext* context,
                                            const v1::ResolvePresetsRequest* request,
                                            v1::ResolvedPresets* response) {
  const auto caller = callers_.Find(*context, {Scope::kRead});
  if (!caller.ok()) return rpc::ToGrpc(caller.status());
  return rpc::ToGrpc(Resolve(caller->tenant, request->presets(), response));
}

absl::Status PresetsService::Resolve(const std::string& tenant, const v1::JobPresets& named,
                                     v1::ResolvedPresets* response) {
  const auto loaded = library_.Load(tenant, {named.bundles().begin(), named.bundles().end()});
  if (!loaded.ok()) return loaded.status();
  const presets::PresetSet& set = (*loaded)->set();
  const auto chosen = ChoosePresets(set, {named.printer(), named.process(), named.filament()});
  if (!chosen.ok()) return chosen.status();
  const auto values = CombinePresets(set, *chosen);
  if (!values.ok()) return values.status();
  v1::JobPresets& full = *response->mutable_presets();
  full.set_printer(chosen->printer->name);
  full.set_process(chosen->process->name);
  full.set_filament(chosen->filament->name);
  full.mutable_bundles()->Assign((*loaded)->bundles().begin(), (*loaded)->bundles().end());
  response->mutable_notes()->Assign(chosen->notes.begin(), chosen->notes.end());
  for (const presets::SourcedValue& each : *values) {
    v1::ResolvedSetting& setting = *response->add_settings();
    setting.set_key(each.key);
    setting.set_value(each.value);
    if (each.from == nullptr) continue;
    setting.set_preset(each.from->name);
    setting.set_file(each.from->file);
  }
  return absl::OkStatus();
}

}  // namespace slicefarm::coordinator
