#include "gpu/shader.h"

#include "base/check.h"
#include "gpu_fixture.h"
#include "render/shader_library.h"
#include "shared/batch_arguments.h"
#include "shared/cell_push.h"
#include "shared/sort.h"

namespace tetralux::gpu {
namespace {

using test::GpuTest;

std::vector<VkDescriptorType> types(const Shader& shader) {
  std::vector<VkDescriptorType> result;
  for (const auto& binding : shader.interface().bindings) result.push_back(binding.type);
  return result;
}

TEST_F(GpuTest, ReflectionFindsWhatTheShaderDeclares) {
  const Shader cull = render::loadShader(context(), "cull/cull.comp");
  EXPECT_EQ(cull.interface().stage, VK_SHADER_STAGE_COMPUTE_BIT);
  constexpr auto kTexel = VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
  constexpr auto kStorage = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  EXPECT_EQ(types(cull),
            (std::vector{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, kTexel, kTexel, kTexel, kTexel, kStorage, kStorage}));
  EXPECT_EQ(cull.interface().pushConstantBytes, 32u);

  const Shader fragment = render::loadShader(context(), "raster/fan.frag");
  EXPECT_EQ(fragment.interface().stage, VK_SHADER_STAGE_FRAGMENT_BIT);
  EXPECT_EQ(fragment.interface().pushConstantBytes, sizeof(shared::CellPush));
}

TEST_F(GpuTest, WorkgroupSizesAreThoseThatTheHostCountsWith) {
  EXPECT_EQ(render::loadShader(context(), "project/project.comp").interface().localSize[0], shared::PROJECT_WORKGROUP);
  EXPECT_EQ(render::loadShader(context(), "sort/tile_upsweep.comp").interface().localSize[0],
            shared::SORT_TILE_THREADS);
  EXPECT_EQ(render::loadShader(context(), "sort/tile_downsweep.comp").interface().localSize[0],
            shared::SORT_TILE_THREADS);
  EXPECT_EQ(render::loadShader(context(), "sort/chunk_upsweep.comp").interface().localSize[0],
            shared::SORT_CHUNK_THREADS);
  EXPECT_EQ(render::loadShader(context(), "sort/chunk_downsweep.comp").interface().localSize[0],
            shared::SORT_CHUNK_THREADS);
}

TEST(Reflect, OtherBytesAreNoModule) {
  const std::vector<std::uint32_t> words(16, 7);
  EXPECT_THROW(reflect(words), CheckFailure);
  EXPECT_THROW(reflect({}), CheckFailure);
}

}  // namespace
}  // namespace tetralux::gpu
