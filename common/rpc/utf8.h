#pragma once

#include "common/base/utf8.h"

namespace slicefarm::rpc {

using slicefarm::IsUtf8;
using slicefarm::ToUtf8;

}  // namespace slicefarm::rpc
