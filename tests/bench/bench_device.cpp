#include "bench_device.h"

#include <cstdlib>
#include <memory>

#include "base/check.h"
#include "base/error.h"

namespace tetralux::bench {
namespace {

std::unique_ptr<gpu::Context> context;

std::unique_ptr<gpu::Context> makeContext() {
  gpu::ContextOptions options;
  if (const char* wanted = std::getenv("TETRALUX_TEST_DEVICE")) options.device = wanted;
  try {
    return std::make_unique<gpu::Context>(options);
  } catch (const Error&) {
    return nullptr;
  }
}

}  // namespace

const gpu::Context* device() {
  static const bool isMade = [] {
    context = makeContext();
    return true;
  }();
  return isMade ? context.get() : nullptr;
}

void releaseDevice() { context.reset(); }

double passSeconds(const gpu::Recorder& recorder, const std::string& pass) {
  for (const gpu::PassTime& time : recorder.passTimes()) {
    if (time.name == pass) return 1e-3 * time.gpuMs;
  }
  checkFailed(__FILE__, __LINE__, "no pass " + pass);
}

const TetMesh& gridMesh() {
  static const TetMesh mesh = jitteredGrid(26, 26, 25, glm::dvec3(0), glm::dvec3(1), 0.15, 1, waveField);
  return mesh;
}

Camera gridCamera() {
  Camera camera;
  camera.eye = {1.9, -2.3, 1.4};
  camera.center = {0.5, 0.5, 0.5};
  return camera;
}

TransferFunction gridTransfer() {
  return TransferFunction({{0.0, {0.1, 0.1, 0.9}, 0.2},
                           {0.35, {0.1, 0.9, 0.4}, 1.0},
                           {0.55, {0.9, 0.9, 0.1}, 0.1},
                           {0.8, {0.9, 0.4, 0.1}, 3.0},
                           {1.0, {1.0, 0.1, 0.1}, 0.5}},
                          "bench");
}

}  // namespace tetralux::bench
