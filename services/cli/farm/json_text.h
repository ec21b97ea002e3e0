#pragma once

#include <google/protobuf/message.h>

#include <string>

#include "slicefarm/v1/jobs.pb.h"

namespace slicefarm::cli {

/// Returns a message as JSON with the names of its proto, on one line without a line end.
std::string JsonLine(const google::protobuf::Message& message);

/// Returns a message as JSON on several lines.
std::string IndentedJson(const google::protobuf::Message& message);

/// Returns a job as JsonLine does, without the settings of its spec and with `output`, the file of
/// its result; empty: no file.
std::string JsonOfJob(v1::Job job, const std::string& output);

}  // namespace slicefarm::cli
