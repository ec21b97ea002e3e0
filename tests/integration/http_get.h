#pragma once

#include <string>

namespace slicefarm {

/// Returns the whole answer of a server on this machine to GET `path`; empty without an answer.
std::string HttpGet(int port, const std::string& path);

}  // namespace slicefarm
