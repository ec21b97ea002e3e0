#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "absl/status/statusor.h"
#include "common/config/resolve.h"
#include "common/base/sha256.h"
#include "common/wire/layer_wire.h"
#include "common/wire/motion_options_wire.h"
#include "common/wire/program_wire.h"
#include "common/wire/settings_wire.h"
#include "common/wire/slicing_wire.h"
#include "common/wire/start_wire.h"
#include "services/beading/algo/local_beading_stage.h"
#include "services/infill/algo/local_infill_stage.h"
#include "services/motion/algo/local_motion_stage.h"
#include "services/ordering/algo/local_ordering_stage.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/fuzz/calls.pb.h"

// Seeds for the fuzzers of calls: those of a small job, as its stages get them.
//
//   make_seeds tests/corpus/fuzz

namespace slicefarm::fuzz {
namespace {

/// A box of 6 x 6 x 4 mm.
constexpr std::string_view kBox =
    "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 0 0 4\nv 6 0 4\nv 6 6 4\nv 0 6 4\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

constexpr std::pair<const char*, const char*> kSettings[] = {
    {"layer_height", "1"},         {"first_layer_height", "1"},
    {"nozzle_diameter", "2"},      {"perimeters", "1"},
    {"top_solid_layers", "1"},     {"bottom_solid_layers", "1"},
    {"fill_density", "20%"},       {"extrusion_width", "1.2"},
    {"start_gcode", "G28 ; home"}, {"layer_gcode", ";[layer_num]"}};

/// Dies of what is no seed.
template <typename T>
T Must(absl::StatusOr<T> value) {
  if (value.ok()) return *std::move(value);
  std::fprintf(stderr, "%s\n", value.status().ToString().c_str());
  std::abort();
}

class Seeds {
 public:
  explicit Seeds(std::string folder) : folder_(std::move(folder)) {}

  void Write(const std::string& target, const std::string& name,
             const google::protobuf::Message& message) const {
    const std::filesystem::path path = std::filesystem::path(folder_) / target;
    std::filesystem::create_directories(path);
    std::ofstream(path / name, std::ios::binary) << message.SerializeAsString();
  }

 private:
  const std::string folder_;
};

/// Seeds hold no build id: the fuzzers fill in their own.
template <typename Start>
void Anonymous(Start* start) {
  start->mutable_call()->clear_build_id();
}

v1::JobSpec Spec() {
  v1::JobSpec spec;
  v1::Object& object = *spec.add_objects();
  object.set_mesh_sha256(Sha256Hex(kBox));
  object.set_name("box.obj");
  object.set_format(v1::MESH_FORMAT_OBJ);
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
}

/// Each stage's call, with what the stage before it gave.
void WriteStageSeeds(const Seeds& seeds) {
  std::vector<config::Setting> given;
  for (const auto& [key, value] : kSettings) given.push_back({key, value});
  JobSettings settings = Must(config::Resolve(given)).settings;
  settings.slicing.thumbnails_px = {{16, 16}};
  StageCall call;
  call.job_id = "seed";

  SliceInput input;
  input.files.push_back({"box.obj", MeshFormat::kObj, std::string(kBox)});
  input.placements.resize(1);
  SliceCall slice;
  v1::SliceStart& slice_start = *slice.add_requests()->mutable_start();
  if (!ToProto(call, input, settings.slicing, &slice_start).ok()) std::abort();
  Anonymous(&slice_start);
  slice.add_requests()->set_chunk(std::string(kBox));
  seeds.Write("slicing", "box", slice);
  const SlicedJob job =
      Must(slicing::MakeLocalSlicing()->Slice(call, std::move(input), settings.slicing));

  const auto count = static_cast<int32_t>(job.layers.size());
  const LayerRange range = {1, count - 1};  // with neighbours on both sides
  const std::vector<LayerPlan> plans(range.size(), LayerPlan{{1'000'000, 0}, {{0, 0}}});
  const Neighbourhood neighbourhood = {range, count, job.layers};
  BeadCall bead;
  BeadStart bead_start{{call, settings.beading}, range, count};
  ToProto(bead_start, bead.add_requests()->mutable_start());
  Anonymous(bead.mutable_requests(0)->mutable_start());
  FillCall fill;
  FillStart fill_start{{call, settings.infill}, range, count};
  ToProto(fill_start, fill.add_requests()->mutable_start());
  Anonymous(fill.mutable_requests(0)->mutable_start());
  WorkCall work;
  if (!ToProto(WorkStart{call, settings, range, count, plans}, work.add_requests()->mutable_start())
           .ok()) {
    std::abort();
  }
  Anonymous(work.mutable_requests(0)->mutable_start());
  for (const SlicedLayer& layer : job.layers) {
    v1::SlicedLayer proto;
    if (!ToProto(layer, &proto).ok()) std::abort();
    *bead.add_requests()->mutable_layer() = proto;
    *fill.add_requests()->mutable_neighbour() = proto;
    *work.add_requests()->mutable_layer() = proto;
  }
  seeds.Write("beading", "box", bead);
  bead.mutable_requests(0)->mutable_start()->mutable_options()->set_generator(
      v1::WALL_GENERATOR_CLASSIC);
  seeds.Write("beading", "box_classic", bead);
  seeds.Write("worker", "box", work);

  auto walled = Must(beading::MakeLocalBeading()->Bead(call, neighbourhood, settings.beading));
  for (const WalledLayer& layer : walled)
    if (!ToProto(layer, fill.add_requests()->mutable_layer()).ok()) std::abort();
  seeds.Write("infill", "box", fill);
  auto filled = Must(
      infill::MakeLocalInfill()->Fill(call, std::move(walled), neighbourhood, settings.infill));

  OrderCall order;
  ToProto(OrderStart{call, settings.ordering}, order.add_requests()->mutable_start());
  Anonymous(order.mutable_requests(0)->mutable_start());
  for (size_t i = 0; i < filled.size(); ++i) {
    v1::PlannedLayer& planned = *order.add_requests()->mutable_layer();
    if (!ToProto(filled[i], planned.mutable_layer()).ok()) std::abort();
    if (!ToProto(plans[i], planned.mutable_plan()).ok()) std::abort();
  }
  seeds.Write("ordering", "box", order);
  auto ordered =
      Must(ordering::MakeLocalOrdering()->Order(call, std::move(filled), plans, settings.ordering));

  MotionCall motion;
  ToProto(ProgramStart{call, settings.motion}, motion.add_requests()->mutable_start());
  Anonymous(motion.mutable_requests(0)->mutable_start());
  for (const OrderedLayer& layer : ordered)
    if (!ToProto(layer, motion.add_requests()->mutable_layer()).ok()) std::abort();
  const auto programs =
      Must(motion::MakeLocalMotion()->Program(call, std::move(ordered), settings.motion));
  ProgramSummary summary;
  for (const LayerProgram& program : programs) {
    summary.layers.push_back(
        {program.frame, program.entry, program.exit, program.stats.TimeS(), false});
    summary.total.Add(program.stats);
  }
  summary.object_names = job.object_names;
  summary.settings_text = "layer_height = 1\n";
  if (!ToProto(summary, motion.mutable_frame()).ok()) std::abort();
  *motion.mutable_frame()->mutable_options() = ToProto(settings.motion);
  seeds.Write("motion", "box", motion);
}

}  // namespace
}  // namespace slicefarm::fuzz

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: make_seeds FOLDER\n"), 1;
  const slicefarm::fuzz::Seeds seeds(argv[1]);
  slicefarm::fuzz::WriteCoordinatorSeeds(seeds);
  slicefarm::fuzz::WriteStageSeeds(seeds);
  return 0;
}
