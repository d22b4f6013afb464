// Pipelines of one shader for different specialisation constants. Shader and pipelines are made when first needed: a
// large module takes tens of milliseconds where it is validated.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gpu/pipeline.h"
#include "render/integration/integration.h"

namespace tetralux::render {

// What a frame's shaders are specialised for: properties of scene and view that hold for all cells.
struct FrameVariant {
  bool perspective = true;
  bool cellField = false;
  bool nearCells = false;
  bool wideAddressing = false;
  bool silhouette = false;
  bool gator = false;
  bool emissionPerLength = false;
  bool countWork = false;             // SPEC_COUNT_WORK; not in specConstants()
  std::uint32_t dispatchThreads = 1;  // SPEC_DISPATCH_THREADS
  std::uint32_t turnRounds = 0;       // SPEC_TURN_ROUNDS; not in specConstants()
  std::uint32_t jobLanes = 1;         // SPEC_JOB_LANES; likewise
  bool doublePrecision = false;       // of rays that walk; not in specConstants(): shaders of their own
  std::uint32_t subpixels = 0;        // SPEC_SUBPIXELS; not in specConstants()
  std::uint32_t output = 0;           // shared/target_output.h
  IntegrationVariant integration;     // of the shaders that draw segments; not in specConstants()

  gpu::SpecConstants specConstants() const;
};

class ComputeVariants {
 public:
  //   shader   name under shaders-glsl
  ComputeVariants(const gpu::Context& context, const std::string& shader);

  const gpu::ComputePipeline& get(const gpu::SpecConstants& constants);

 private:
  const gpu::Context& context_;
  std::string name_;
  std::optional<gpu::Shader> shader_;
  std::map<std::vector<std::pair<std::uint32_t, std::uint32_t>>, gpu::ComputePipeline> pipelines_;
};

}  // namespace tetralux::render
