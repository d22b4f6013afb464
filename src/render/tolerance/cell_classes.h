// Which integration a mesh's cells need to stay within an error, counted on the device.
#pragma once

#include "render/gpu_mesh.h"
#include "render/transfer_buffer.h"

namespace tetralux::render {

// Cells by the cheapest method that is good enough for every segment in them, from any view.
struct CellClasses {
  std::uint32_t empty = 0;    // neither absorb nor emit
  std::uint32_t average = 0;  // Integration::Average is within the limit
  std::uint32_t linear = 0;   // no control point of the transfer function inside: Integration::Linear is exact
  std::uint32_t pieces = 0;   // control points inside: Integration::Exact
  // Largest bound of the error of Integration::Average in cells without a control point inside, relative to a
  // segment's opacity.
  double worstMean = 0.0;
  // Largest change of a channel of luminance along a part of a segment: within one cell and one piece.
  double worstChange = 0.0;
};

// Takes about as long as a cull pass, and does not depend on the view. Emission must be per extinction.
//   limit   error of a segment's colour relative to its opacity: a ray then errs by no more, however many cells it
//   meets
CellClasses classifyCells(const gpu::Context& context, const GpuMesh& mesh, const TransferBuffer& transfer,
                          bool wideAddressing, double limit);

}  // namespace tetralux::render
