// Pass "check": how many shared faces and pairs across gaps the sort keys put the wrong way round.
#pragma once

#include "render/order/cell_order.h"
#include "render/order/relations.h"
#include "shared/visibility.h"

namespace tetralux::render {

struct CheckOptions {
  bool tiesAreApart = false;      // cells of equal keys are composited apart, in the right order by themselves
  bool onlyWhetherExact = false;  // gaps need not be looked at when a shared face is misordered already
};

class OrderCheck {
 public:
  //   topology, relations   must outlive the check
  OrderCheck(const gpu::Context& context, const GpuTopology& topology, Relations& relations);

  // Runs the recorder: counts shared faces and, where the mesh is not convex, pairs of cells across gaps into a report.
  // The keys must be final; barriers are the check's own.
  //   range   bits of the key that the sort will look at
  void run(const OrderInputs& inputs, SortRange range, const CheckOptions& options, OrderReport& report);

  std::uint64_t sizeBytes() const { return count_.sizeBytes(); }

 private:
  void recordFaces(const OrderInputs& inputs, SortRange range, bool tiesAreApart);
  shared::OrderCount counted() const;

  const gpu::Context& context_;
  const GpuTopology& topology_;
  Relations& relations_;
  ComputeVariants check_;
  gpu::Buffer count_;
};

// What orders and checks need beside the mesh. Made when a frame asks for one of them.
struct VisibilityKit {
  GpuTopology topology;
  Relations relations;
  OrderCheck check;

  VisibilityKit(const gpu::Context& context, const Adjacency& adjacency,
                const std::vector<std::array<std::uint32_t, 2>>& overlaps)
      : topology(context, adjacency, overlaps), relations(context), check(context, topology, relations) {}
  std::uint64_t sizeBytes() const { return topology.sizeBytes() + relations.sizeBytes() + check.sizeBytes(); }
};

}  // namespace tetralux::render
