#include <algorithm>

#include "common/wire/layers/message_stream.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/slice_object_wire.h"
#include "common/wire/slicing_wire.h"
#include "services/slicing/algo/local_slicing_stage.h"
#include "tests/fuzz/calls.pb.h"
#include "tests/fuzz/proto_mutator.h"
#include "tests/fuzz/stage_call.h"

namespace slicefarm::fuzz {
namespace {

/// Limit of sizes, so that no input takes long only because of its size.
constexpr int64_t kMaxPx = 64;

bool IsSmall(const v1::SliceStart& start) {
  const auto options = OptionsFromBytes<SlicingOptions>(start.options());
  if (!options.ok()) return true;
  return std::ranges::all_of(options->thumbnails, [](const ThumbnailSize& size) {
    return size.width_px <= kMaxPx && size.height_px <= kMaxPx;
  });
}

void Run(const SliceCall& given) {
  static const auto stage = slicing::MakeLocalSlicing();
  Requests<v1::SliceRequest> requests(given.requests());
  for (const v1::SliceRequest& request : given.requests()) {
    if (request.has_start() && !IsSmall(request.start())) return;
    for (const v1::SliceObject& object : request.start().objects()) CheckRoundTrip(object);
  }
  auto start = ReadStart<v1::SliceRequest>(requests, WithDeadline());
  if (!start.ok()) return;
  const absl::Status read = ReadEach<v1::SliceRequest>(
      requests, [&](const v1::SliceRequest& request) { return start->files.Add(request.chunk()); });
  if (!read.ok()) return;
  auto input = start->files.Finish();
  if (!input.ok()) return;
  const auto job = stage->Slice(start->call, *std::move(input), start->options);
  if (!job.ok()) return;
  CheckRoundTrip(Encoded<v1::SliceSummary>(*job));
  for (const PlacedCopy& copy : job->copies) CheckRoundTrip(Encoded<v1::PlacedCopy>(copy));
  for (const SlicedLayer& layer : job->layers) CheckRoundTrip(Encoded<v1::SlicedLayer>(layer));
}

}  // namespace
}  // namespace slicefarm::fuzz

SLICEFARM_PROTO_FUZZER(slicefarm::fuzz::SliceCall, slicefarm::fuzz::Run)
