#include "common/wire/stage_jobs_wire.h"

#include <utility>

#include "common/model/options/beading_options.h"
#include "common/model/options/infill_options.h"
#include "common/stage/exposure_job.h"
#include "common/stage/motion_job.h"
#include "common/stage/ordering_job.h"
#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/options_wire.h"
#include "common/wire/support/repeated_wire.h"
#include "common/wire/support/wire_error.h"

namespace slicefarm {
namespace {

template <typename Proto>
absl::StatusOr<std::vector<Copy>> TakeCopies(const Proto& proto) {
  std::vector<Copy> copies;
  absl::Status status = CheckCopyCount(proto.copies_size(), "copies");
  if (status.ok()) status = AllFromProto(proto.copies(), "copies", &copies);
  if (!status.ok()) return status;
  return copies;
}

}  // namespace

absl::Status ToProto(const BeadingTable& table, v1::BeadingTable* proto) {
  proto->set_rows(PackFields(table));
  return absl::OkStatus();
}
absl::StatusOr<BeadingTable> FromProto(const v1::BeadingTable& proto) {
  auto table = OptionsFromBytes<BeadingTable>(proto.rows());
  return table.ok() ? table : Within("rows", table.status());
}

absl::Status ToProto(const InfillTable& table, v1::InfillTable* proto) {
  proto->set_rows(PackFields(table));
  return absl::OkStatus();
}
absl::StatusOr<InfillTable> FromProto(const v1::InfillTable& proto) {
  auto table = OptionsFromBytes<InfillTable>(proto.rows());
  return table.ok() ? table : Within("rows", table.status());
}

absl::Status ToProto(const OrderingJob& job, v1::OrderingJob* proto) {
  proto->set_options(PackFields(job.options));
  return AllToProto(job.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<OrderingJob> FromProto(const v1::OrderingJob& proto) {
  auto options = OptionsFromBytes<OrderingOptions>(proto.options());
  if (!options.ok()) return Within("options", options.status());
  absl::StatusOr<std::vector<Copy>> copies = TakeCopies(proto);
  if (!copies.ok()) return copies.status();
  return OrderingJob{*std::move(options), *std::move(copies)};
}

absl::Status ToProto(const MotionJob& job, v1::MotionJob* proto) {
  proto->set_options(PackFields(job.options));
  *proto->mutable_facts() = ToProto(job.facts);
  return absl::OkStatus();
}
absl::StatusOr<MotionJob> FromProto(const v1::MotionJob& proto) {
  auto options = OptionsFromBytes<MotionOptions>(proto.options());
  if (!options.ok()) return Within("options", options.status());
  absl::StatusOr<JobFacts> facts = FromProto(proto.facts());
  if (!facts.ok()) return Within("facts", facts.status());
  return MotionJob{*std::move(options), *std::move(facts)};
}

absl::Status ToProto(const ExposureJob& job, v1::ExposureJob* proto) {
  proto->set_settings(PackFields(job.settings));
  return AllToProto(job.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<ExposureJob> FromProto(const v1::ExposureJob& proto) {
  auto settings = OptionsFromBytes<ExposureSettings>(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<std::vector<Copy>> copies = TakeCopies(proto);
  if (!copies.ok()) return copies.status();
  return ExposureJob{*std::move(settings), *std::move(copies)};
}

}  // namespace slicefarm
