#include <span>
#include <string>

#include "common/base/sha256.h"
#include "common/wire/options/given_settings_wire.h"
#include "common/wire/scene_wire.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/seeds.h"

namespace slicefarm::fuzz {
namespace {

/// Returns an object as in a project: a body and a modifier, a range of heights, two copies.
SceneObject OfParts() {
  SceneObject object = ObjectOfFile("body", 0, {}, 2);
  object.parts.push_back(object.parts[0]);
  object.parts[1].mesh = {0, 0, 2, 4};
  object.parts[1].role = PartRole::kModifier;
  object.parts[1].to_object(2, 3) = 0.5;
  object.parts[1].settings = {{"fill_density", "40%", Source::kProfile}};
  object.ranges = {{0.5, 1, {{"layer_height", "0.1", Source::kProfile}}}};
  object.instances[1].placed = true;
  return object;
}

v1::JobSpec Spec() {
  v1::JobSpec spec;
  v1::Object& object = *spec.add_objects();
  object.set_mesh_sha256(Sha256Hex(kBox));
  object.set_name("box.obj");
  object.set_format(v1::MESH_FORMAT_OBJ);
  const StoredMesh mesh = {Sha256Hex(kBox), "box.obj", MeshFormat::kObj};
  ToProto(OfParts(), std::span(&mesh, 1), spec.add_objects());
  *spec.add_project_settings() = ToProto(Setting{"perimeters", "3", Source::kProfile});
  spec.add_without_effect("painted seams");
  spec.set_generic(true);
  spec.add_allow("several_tools");
  spec.add_notes()->set_text("painted fuzzy skin of `a`: without effect");
  for (const auto& [key, value] : kSettings) {
    v1::Setting& setting = *spec.add_settings();
    setting.set_key(key);
    setting.set_value(value);
  }
  return spec;
}

CoordinatorCalls UploadAndCreate() {
  CoordinatorCalls calls;
  v1::UploadMeshRequest& chunk = *calls.add_calls()->mutable_upload()->add_requests();
  chunk.set_sha256(Sha256Hex(kBox));
  chunk.set_size(std::ssize(kBox));
  chunk.set_data(std::string(kBox));
  v1::CreateJobRequest& create = *calls.add_calls()->mutable_create_job();
  create.set_request_id("8c5ee5a2-6ba7-4f0b-9f9f-6b6b7a3a7a3a");
  *create.mutable_spec() = Spec();
  (*create.mutable_labels())["order"] = "17";
  create.set_priority(v1::JOB_PRIORITY_INTERACTIVE);
  create.mutable_deadline()->set_seconds(4'000'000'000);
  return calls;
}

CoordinatorCalls PresetCalls() {
  CoordinatorCalls calls = UploadAndCreate();
  v1::ImportPresetsRequest& import = *calls.add_calls()->mutable_import_presets();
  import.set_name("acme");
  v1::PresetFile& file = *import.add_files();
  file.set_path("Acme.ini");
  file.set_content(
      "[vendor]\nname = Acme\n[print:P]\nlayer_height = 1\nfirst_layer_height = 1\n"
      "[filament:F]\ntemperature = 207\n[printer:A]\nnozzle_diameter = 2\n"
      "gcode_flavor = marlin2\nbed_shape = 0x0,90x0,90x90,0x90\ndefault_print_profile = P\n"
      "default_filament_profile = F\n");
  calls.add_calls()->mutable_list_presets()->set_printer("A");
  v1::JobPresets& named = *calls.add_calls()->mutable_resolve_presets()->mutable_presets();
  named.set_printer("A");
  named.add_bundles("acme@1");
  v1::PutProfileRequest& overlay = *calls.add_calls()->mutable_put_profile();
  overlay.set_name("overlay.A__with__F");
  *overlay.add_settings() = ToProto(Setting{"pressure_advance", "0.04", Source::kRequest});
  v1::JobSpec& spec = *calls.add_calls()->mutable_create_job()->mutable_spec();
  *spec.mutable_objects() = Spec().objects();
  *spec.mutable_presets() = named;
  v1::CalibrationTable& table = *spec.mutable_calibration();
  table.set_kind("pressure-advance");
  table.set_unit("s");
  table.set_setting("pressure_advance");
  v1::CalibrationValue& value = *table.add_values();
  value.set_label("0.02");
  value.set_value(0.02);
  value.set_to_mm(5);
  calls.add_calls()->mutable_delete_preset_bundle()->set_name("acme");
  return calls;
}

}  // namespace

void WriteCoordinatorSeeds(const Seeds& seeds) {
  CoordinatorCalls calls = UploadAndCreate();
  seeds.Write("coordinator", "create", calls);
  CoordinatorCalls check = UploadAndCreate();
  check.mutable_calls(1)->mutable_create_job()->set_validate_only(true);
  seeds.Write("coordinator", "check", check);
  CoordinatorCalls batch = UploadAndCreate();
  v1::BatchCreateJobsRequest requests;
  *requests.add_requests() = batch.calls(1).create_job();
  *requests.add_requests() = batch.calls(1).create_job();
  requests.mutable_requests(1)->mutable_spec()->set_mode(v1::JOB_MODE_QUOTE);
  *batch.add_calls()->mutable_batch_create_jobs() = requests;
  seeds.Write("coordinator", "batch", batch);

  CoordinatorCalls plates = UploadAndCreate();
  *plates.mutable_calls(1)->mutable_create_plates()->add_requests() = batch.calls(1).create_job();
  plates.mutable_calls(1)->mutable_create_plates()->mutable_requests(0)->clear_request_id();
  seeds.Write("coordinator", "plates", plates);
  v1::ListJobsRequest& list = *calls.add_calls()->mutable_list_jobs();
  list.set_page_size(2);
  list.set_page_token("7");
  list.add_states(v1::JOB_STATE_QUEUED);
  (*list.mutable_labels())["order"] = "17";
  list.mutable_created_from()->set_seconds(1'000'000'000);
  list.mutable_created_before()->set_seconds(4'000'000'000);
  calls.add_calls()->mutable_get_upload()->set_sha256(Sha256Hex(kBox));
  seeds.Write("coordinator", "list", calls);
  CoordinatorCalls unknown;
  unknown.add_calls()->mutable_get_job()->set_id("0123");
  unknown.add_calls()->mutable_watch_job()->set_id("0123");
  unknown.add_calls()->mutable_cancel_job()->set_id("0123");
  unknown.add_calls()->mutable_delete_job()->set_id("0123");
  unknown.add_calls()->mutable_download()->set_artifact(v1::ARTIFACT_GCODE);
  seeds.Write("coordinator", "unknown", unknown);
  CoordinatorCalls profiles = UploadAndCreate();
  v1::PutProfileRequest& put = *profiles.add_calls()->mutable_put_profile();
  put.set_name("pla");
  *put.mutable_settings() = Spec().settings();
  profiles.add_calls()->mutable_get_profile()->set_name("pla");
  profiles.add_calls()->mutable_list_profiles()->set_page_size(3);
  v1::CreateJobRequest& create = *profiles.add_calls()->mutable_create_job();
  *create.mutable_spec()->mutable_objects() = Spec().objects();
  create.mutable_spec()->add_profiles("pla@1");
  seeds.Write("coordinator", "profiles", profiles);
  seeds.Write("coordinator", "presets", PresetCalls());
}

}  // namespace slicefarm::fuzz
