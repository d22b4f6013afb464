// A mesh on the device with a camera, for tests of single passes.
#pragma once

#include "mesh/generate.h"
#include "render/frame.h"

namespace tetralux::test {

struct PassScene {
  PassScene(const gpu::Context& gpuContext, TetMesh tetMesh, const TransferFunction& transferFunction,
            const Camera& cam, ImageSize imageSize)
      : context(gpuContext),
        mesh(std::move(tetMesh)),
        field(scalarField(mesh, "", "test")),
        gpuMesh(context, mesh, field),
        transfer(context, transferFunction, gpuMesh.space()),
        camera(cam),
        size(imageSize),
        setup(render::makeFrameSetup(camera, size, gpuMesh.space(), gpuMesh.cellCount(), transfer.supportCount(), 24)),
        storage(context, gpuMesh.cellCount(), render::bestSortVariant(context.info())) {
    variant.perspective = setup.perspective;
    variant.nearCells = setup.nearCells;
    variant.cellField = gpuMesh.isCellField();
    gpu::upload(context, storage.view, &setup.view, sizeof setup.view);
    const shared::FrameCounters zero{};
    gpu::upload(context, storage.counters, &zero, sizeof zero);
  }

  shared::FrameCounters counters() const {
    return gpu::downloadVector<shared::FrameCounters>(context, storage.counters, 1)[0];
  }

  const gpu::Context& context;
  TetMesh mesh;
  ScalarField field;
  render::GpuMesh gpuMesh;
  render::TransferBuffer transfer;
  Camera camera;
  ImageSize size;
  render::FrameSetup setup;
  render::FrameVariant variant;
  render::FrameStorage storage;
};

}  // namespace tetralux::test
