#include "common/wire/slicing_wire.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "common/model/limits.h"
#include "common/stage/slice_input_test.h"
#include "common/wire/support/round_trip_test.h"

namespace slicefarm::slicing_wire_test {
namespace {

SliceInput TwoFiles() {
  return InputOf({{"a.stl", MeshFormat::kStl, "solid a"}, {"b.obj", MeshFormat::kObj, "v 0 0 0"}});
}

v1::SliceStart StartOf(const SliceInput& input) {
  StageCall call;
  call.job_id = "job-1";
  v1::SliceStart proto;
  EXPECT_TRUE(ToProto(call, input, SlicingOptions{}, &proto).ok());
  return proto;
}

// A chunk may contain the end of one file and the beginning of the next, or a single byte.
TEST(SliceInputReader, PutsFilesTogetherFromAnyChunks) {
  SliceInput input = TwoFiles();
  input.advise_orientations = true;
  for (const size_t chunk : {size_t{1}, size_t{5}, size_t{100}}) {
    absl::StatusOr<SliceStart> start = FromProto(StartOf(input));
    ASSERT_TRUE(start.ok()) << start.status();
    EXPECT_EQ(start->call.job_id, "job-1");
    EXPECT_EQ(start->options, SlicingOptions{});
    const std::string bytes = input.files[0].bytes + input.files[1].bytes;
    for (size_t i = 0; i < bytes.size(); i += chunk)
      ASSERT_TRUE(start->files.Add(bytes.substr(i, chunk)).ok());
    const absl::StatusOr<SliceInput> back = start->files.Finish();
    ASSERT_TRUE(back.ok()) << back.status();
    ASSERT_EQ(back->files.size(), 2);
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(back->files[i].name, input.files[i].name);
      EXPECT_EQ(back->files[i].format, input.files[i].format);
      EXPECT_EQ(back->files[i].bytes, input.files[i].bytes);
    }
    EXPECT_EQ(back->objects, input.objects);
    EXPECT_TRUE(back->advise_orientations);
  }
}

TEST(SliceInputReader, RefusesOtherThanWhatWasAnnounced) {
  const v1::SliceStart start = StartOf(TwoFiles());
  auto more = SliceInputReader::Begin(start);
  ExpectMalformed(more->Add(std::string(15, 'x')), "chunk");
  auto fewer = SliceInputReader::Begin(start);
  EXPECT_TRUE(fewer->Add(std::string(13, 'x')).ok());
  ExpectMalformed(fewer->Finish().status(), "chunk");
}

TEST(SliceInputReader, RefusesStartsThatNoJobHas) {
  v1::SliceStart start = StartOf(TwoFiles());
  start.clear_files();
  ExpectMalformed(FromProto(start).status(), "files");
  start = StartOf(TwoFiles());
  start.mutable_files(1)->set_size_bytes(-1);
  ExpectMalformed(FromProto(start).status(), "files.size_bytes");
  start = StartOf(TwoFiles());
  start.mutable_objects(1)->clear_to_plate();
  ExpectMalformed(FromProto(start).status(), "objects[1].to_plate");
  start = StartOf(TwoFiles());
  start.clear_options();
  ExpectMalformed(FromProto(start).status(), "options.value 1");
}

TEST(SliceInputReader, RefusesMoreFilesOrObjectsThanAPlateMayHave) {
  v1::SliceStart files = StartOf(TwoFiles());
  while (files.files_size() <= limits::kMaxObjects) files.add_files();
  EXPECT_EQ(DetailOf(FromProto(files).status()).reason, Reason::kRequestTooLarge);
  v1::SliceStart objects = StartOf(TwoFiles());
  while (objects.objects_size() <= limits::kMaxObjects) objects.add_objects();
  EXPECT_EQ(DetailOf(FromProto(objects).status()).reason, Reason::kRequestTooLarge);
}

// Found by fuzz_slicing: the sum of both numbers exceeds 64 bits.
TEST(SliceInputReader, MoreBytesThanCanBeCountedAreRefused) {
  v1::SliceStart start;
  start.add_files()->set_size_bytes(124);
  start.add_files()->set_size_bytes(INT64_MAX);
  const absl::Status status = SliceInputReader::Begin(start).status();
  EXPECT_EQ(DetailOf(status).reason, Reason::kMeshTooLarge) << status;
  EXPECT_EQ(DetailOf(status).metadata.at("got"), std::to_string(INT64_MAX));
}

TEST(SliceSummaryWire, Returns) {
  SlicedJob job;
  // A new member does not compile until it is added here, and thereby to the message.
  auto& [layers, object_names, copies, meshes, thumbnails, orientations] = job;
  orientations = {{"lid", {90, 0, 0}, {1, 2, 3, false}, {4, 0, 5, true}}};
  layers.resize(7);
  object_names = {"a", "b"};
  copies = {{0, {1'000, -2'000}, {{1, 2}, {3, 4}, {5, 6}}}, {1, {}, {}}};
  meshes.resize(2);
  meshes[1].name = "b";
  meshes[1].triangles = 12;
  thumbnails = {{16, 17, "\x89PNG"}};
  const auto proto = ProtoOf<v1::SliceSummary>(job);
  EXPECT_EQ(proto.layer_count(), 7);
  const absl::StatusOr<SlicedJob> back = FromProto(proto);
  ASSERT_TRUE(back.ok()) << back.status();
  EXPECT_TRUE(back->layers.empty()) << "they come one by one";
  EXPECT_EQ(back->object_names, object_names);
  EXPECT_EQ(back->copies, copies);
  EXPECT_EQ(back->meshes, meshes);
  EXPECT_EQ(back->thumbnails, thumbnails);
  EXPECT_EQ(back->orientations, orientations);
}

TEST(SliceSummaryWire, RefusesWhatNoJobHas) {
  for (const int32_t count : {INT32_MIN, -1, 20'001}) {
    v1::SliceSummary proto;
    proto.set_layer_count(count);
    ExpectMalformed(FromProto(proto).status(), "layer_count");
  }
  v1::SliceSummary proto;
  proto.add_copies();
  proto.add_copies()->set_object(-1);
  ExpectMalformed(FromProto(proto).status(), "copies[1].object");
}

}  // namespace
}  // namespace slicefarm::slicing_wire_test
