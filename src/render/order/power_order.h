// The order by power distance.
#pragma once

#include "render/gpu_circumspheres.h"
#include "render/gpu_topology.h"
#include "render/order/key_order.h"
#include "render/order/make_order.h"

namespace tetralux::render {

// Sorts by the power of the eye with respect to the cells' circumspheres: exact on Delaunay meshes and on any part of
// one, wherever the eye is (Edelsbrunner 1990). On others it is no better than centroids.
//
// Two numbers decide about a pair of neighbours: how far apart their circumcentres are, and how far the eye is from
// their common face. Powers have 40 bits, keys 29 of the range of powers over the mesh; where two neighbours have the
// same key, as cospherical ones do (regular grids), their face decides. Left to their cells' indices, and found by the
// check, are chains of more than four such cells behind each other.
class PowerOrder : public KeyOrder {
 public:
  // Throws Error(Device) when the spheres do not fit the device.
  //   mesh       with adjacency; not kept
  //   topology   must outlive the order
  //   check      as for KeyOrder
  PowerOrder(const gpu::Context& context, const OrderMesh& mesh, const GpuTopology& topology, SortVariant variant,
             OrderCheck* check);

  std::uint64_t sizeBytes() const override { return spheres_.sizeBytes(); }

 private:
  void recordKeys(const OrderInputs& inputs) override;

  const GpuTopology& topology_;
  GpuCircumspheres spheres_;
  ComputeVariants keys_;
  ComputeVariants ties_;
};

}  // namespace tetralux::render
