// What a ray has to do, counted: only in frames that are drawn to know it (RenderOptions::countWork). In others the constant is false,
// and nothing of this is in the pipeline.

layout(constant_id = SPEC_COUNT_WORK) const bool kCountWork = false;

uint cellSteps = 0u;

void countCell() {
  if (kCountWork) cellSteps++;
}

// A ray's steps are far fewer than 2^32, a picture's need not be.
#define ADD_WITH_CARRY(low, high, amount) \
  if (atomicAdd(low, amount) > 0xffffffffu - (amount)) atomicAdd(high, 1u)
