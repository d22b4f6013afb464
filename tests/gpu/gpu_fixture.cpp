#include "gpu_fixture.h"

#include <cstdlib>
#include <memory>
#include <string>

#include "base/error.h"
#include "gpu/validation.h"

namespace tetralux::test {
namespace {

std::unique_ptr<gpu::Context> sharedContext;
std::string whyNot;

void makeContext() {
  if (sharedContext || !whyNot.empty()) return;
  try {
    gpu::ContextOptions options;
    options.validation = true;
    // TETRALUX_TEST_DEVICE chooses among several devices, by index or part of a name.
    if (const char* device = std::getenv("TETRALUX_TEST_DEVICE")) options.device = device;
    sharedContext = std::make_unique<gpu::Context>(options);
  } catch (const Error& e) {
    whyNot = e.what();
  }
}

// A driver takes itself down in destructors of static objects, maybe before ours: by then the context has to be gone.
class ContextLifetime : public ::testing::Environment {
 public:
  void TearDown() override { sharedContext.reset(); }
};

[[maybe_unused]] const ::testing::Environment* const contextLifetime =
    ::testing::AddGlobalTestEnvironment(new ContextLifetime);

}  // namespace

void GpuTest::SetUp() {
  makeContext();
  if (!sharedContext) GTEST_SKIP() << whyNot;
  gpu::takeValidationMessages();
}

void GpuTest::TearDown() {
  for (const std::string& message : gpu::takeValidationMessages()) ADD_FAILURE() << "validation: " << message;
}

const gpu::Context& GpuTest::context() { return *sharedContext; }

}  // namespace tetralux::test
