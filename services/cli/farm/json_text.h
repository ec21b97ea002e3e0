#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns a message as JSON in one line, without a line end. The keys are the field names of the
/// proto.
std::string JsonLine(const google::protobuf::Message& message);

/// Returns a message as JSON on several lines.
std::string IndentedJson(const google::protobuf::Message& message);

/// Returns a job as JsonLine does, without the settings of its spec. Adds the key `output`: file of
/// the result; not added if `output` is empty.
std::string JsonOfJob(v1::Job job, const std::string& output);

}  // namespace slicefarm::cli
