#pragma once

#include <string>

namespace slicefarm {

/// The whole answer of a server on this machine to GET `path`; empty if nobody answers.
std::string HttpGet(int port, const std::string& path);

}  // namespace slicefarm
