// Precompiled for tests of what speaks gRPC.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cmake/pch/grpc.h"
