#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// A message as JSON under the names of its proto: on one line, without an end of line.
std::string JsonLine(const google::protobuf::Message& message);

/// The same over several lines.
std::string IndentedJson(const google::protobuf::Message& message);

/// A job as JsonLine has it, without the settings of its spec and with `output`, the file with its
/// result; empty: there is none.
std::string JsonOfJob(v1::Job job, const std::string& output);

}  // namespace slicefarm::cli
