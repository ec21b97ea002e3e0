#include "common/wire/stage_jobs_wire.h"

#include <utility>

#include "common/wire/layers/layer_wire.h"
#include "common/wire/layers/plan_wire.h"
#include "common/wire/options/exposure_options_wire.h"
#include "common/wire/options/infill_options_wire.h"
#include "common/wire/options/motion_options_wire.h"
#include "common/wire/options/settings_wire.h"
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
  for (const BeadingOptions& row : table) *proto->add_rows() = ToProto(row);
  return absl::OkStatus();
}
absl::StatusOr<BeadingTable> FromProto(const v1::BeadingTable& proto) {
  BeadingTable table;
  absl::Status status = CheckRows(proto.rows_size(), "rows");
  if (status.ok()) status = AllFromProto(proto.rows(), "rows", &table);
  if (!status.ok()) return status;
  return table;
}

absl::Status ToProto(const InfillTable& table, v1::InfillTable* proto) {
  ToProto(table, proto->mutable_rows(), proto->mutable_texts());
  return absl::OkStatus();
}
absl::StatusOr<InfillTable> FromProto(const v1::InfillTable& proto) {
  if (absl::Status rows = CheckRows(proto.rows_size(), "rows"); !rows.ok()) return rows;
  return FromProto(proto.rows(), proto.texts(), "rows");
}

absl::Status ToProto(const OrderingJob& job, v1::OrderingJob* proto) {
  if (absl::Status status = ToProto(job.options, proto->mutable_options()); !status.ok())
    return Within("options", status);
  return AllToProto(job.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<OrderingJob> FromProto(const v1::OrderingJob& proto) {
  absl::StatusOr<OrderingOptions> options = FromProto(proto.options());
  if (!options.ok()) return Within("options", options.status());
  absl::StatusOr<std::vector<Copy>> copies = TakeCopies(proto);
  if (!copies.ok()) return copies.status();
  return OrderingJob{*std::move(options), *std::move(copies)};
}

absl::Status ToProto(const MotionJob& job, v1::MotionJob* proto) {
  if (absl::Status status = ToProto(job.options, proto->mutable_options()); !status.ok())
    return Within("options", status);
  *proto->mutable_facts() = ToProto(job.facts);
  return absl::OkStatus();
}
absl::StatusOr<MotionJob> FromProto(const v1::MotionJob& proto) {
  absl::StatusOr<MotionOptions> options = FromProto(proto.options());
  if (!options.ok()) return Within("options", options.status());
  absl::StatusOr<JobFacts> facts = FromProto(proto.facts());
  if (!facts.ok()) return Within("facts", facts.status());
  return MotionJob{*std::move(options), *std::move(facts)};
}

absl::Status ToProto(const ExposureJob& job, v1::ExposureJob* proto) {
  *proto->mutable_settings() = ToProto(job.settings);
  return AllToProto(job.copies, "copies", proto->mutable_copies());
}
absl::StatusOr<ExposureJob> FromProto(const v1::ExposureJob& proto) {
  absl::StatusOr<ExposureSettings> settings = FromProto(proto.settings());
  if (!settings.ok()) return Within("settings", settings.status());
  absl::StatusOr<std::vector<Copy>> copies = TakeCopies(proto);
  if (!copies.ok()) return copies.status();
  return ExposureJob{*std::move(settings), *std::move(copies)};
}

}  // namespace slicefarm
