// The part of the network that stays within a block of BITONIC_BLOCK pairs, in shared memory.
shared uvec2 block[BITONIC_BLOCK];

// All exchanges of one stride. Needs a barrier before, ends with one.
void exchangeInBlock(uint stride, bool isMirrored) {
  for (uint p = gl_LocalInvocationIndex; p < BITONIC_BLOCK / 2u; p += BITONIC_THREADS) {
    const uint low = lowerPlace(p, stride);
    const uint high = higherPlace(low, stride, isMirrored);
    const uvec2 a = block[low];
    const uvec2 b = block[high];
    const bool isKept = isBefore(a, b);
    block[low] = isKept ? a : b;
    block[high] = isKept ? b : a;
  }
  barrier();
}
