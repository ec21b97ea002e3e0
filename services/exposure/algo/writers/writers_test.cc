#include "services/exposure/algo/writers/writers.h"

#include <gtest/gtest.h>

#include "common/base/error.h"
#include "services/exposure/algo/writers/sample_layers_test.h"

namespace slicefarm::exposure::writers_test {
namespace {}  // namespace
}  // namespace slicefarm::exposure::writers_test
