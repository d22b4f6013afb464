// Views and measurements for tests of the order in which cells are drawn.
#pragma once

#include <vector>

#include "render/renderer.h"

namespace tetralux::test {

// From outside and from a place inside the mesh's box, in perspective and parallel.
std::vector<Camera> orderViews(const TetMesh& mesh);

// Bands of colour over the scalars from 0 to 1, with peaks: pictures show the order.
const TransferFunction& orderTransfer();

inline constexpr ImageSize kOrderSize{96, 72};

// A renderer that counts what its order gets wrong, with orderTransfer().
class OrderedRenderer {
 public:
  OrderedRenderer(const gpu::Context& context, const TetMesh& mesh, render::Order order,
                  render::RendererOptions options = {});

  void setTransferFunction(const TransferFunction& transfer) { renderer_.setTransferFunction(transfer); }
  render::FrameStats draw(const Camera& camera) { return renderer_.draw(camera, kOrderSize); }
  Image readImage() { return renderer_.readImage(); }

 private:
  render::Renderer renderer_;
};

// The report of a single picture.
render::OrderReport reportOf(const gpu::Context& context, const TetMesh& mesh, render::Order order,
                             const Camera& camera);

// The exact picture.
Image exactImage(const TetMesh& mesh, const TransferFunction& transfer, const Camera& camera);

}  // namespace tetralux::test
