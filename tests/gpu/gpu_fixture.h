// Tests that need a device: one context for the whole program, with validation; any message fails the test.
#pragma once

#include <gtest/gtest.h>

#include <glm/vec4.hpp>
#include <vector>

#include "gpu/commands.h"
#include "gpu/context.h"

namespace tetralux::test {

class GpuTest : public ::testing::Test {
 protected:
  // Skips the test, visibly, where there is no usable device or no validation layer.
  void SetUp() override;
  void TearDown() override;

  static const gpu::Context& context();
};

// Runs `record` on a command buffer and waits.
template <typename Record>
void runCommands(const gpu::Context& context, const Record& record) {
  gpu::CommandBuffer commands(context);
  record(commands);
  commands.submitAndWait();
}

}  // namespace tetralux::test
