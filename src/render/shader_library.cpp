#include "render/shader_library.h"

#include "base/check.h"
#include "shader_modules.h"

namespace tetralux::render {

gpu::Shader loadShader(const gpu::Context& context, const std::string& name) {
  const EmbeddedFile* file = findEmbedded(shader_modules::files(), name + ".spv");
  if (!file) checkFailed(__FILE__, __LINE__, "no shader " + name);
  const auto* words = reinterpret_cast<const std::uint32_t*>(file->data);  // aligned by the embedding
  return gpu::Shader(context, name, {words, file->sizeBytes / sizeof(std::uint32_t)});
}

}  // namespace tetralux::render
