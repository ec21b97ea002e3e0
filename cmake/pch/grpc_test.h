// Precompiled headers for tests of code with gRPC.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cmake/pch/grpc.h"
