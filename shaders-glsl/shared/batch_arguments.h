// Indirect arguments of one batch: VkDispatchIndirectCommand, then VkDrawIndexedIndirectCommand.
#ifndef TETRALUX_SHARED_BATCH_ARGUMENTS_H
#define TETRALUX_SHARED_BATCH_ARGUMENTS_H

#include "types.h"

SHARED_BEGIN

// Invocations per workgroup of project/project.comp; BATCH_CELLS / PROJECT_WORKGROUP groups fit one dimension.
SHARED_CONST uint PROJECT_WORKGROUP = 64;

struct BatchArguments {
  uint groupsX;
  uint groupsY;
  uint groupsZ;
  uint indexCount;
  uint instanceCount;
  uint firstIndex;
  uint vertexOffset;
  uint firstInstance;
};

SHARED_END

#endif
