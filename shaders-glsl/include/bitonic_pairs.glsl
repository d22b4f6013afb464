// The pairs of key and cell that a bitonic sort works on.
//
// The sort is in place. A pair is read and written by one invocation of a dispatch and no other, so it may be read through
// the texel buffer while its neighbours are written through the storage buffer.
//
// Before including: BITONIC_PAIRS_IN and BITONIC_PAIRS are binding numbers.
layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;

layout(binding = BITONIC_PAIRS_IN) uniform usamplerBuffer pairsIn;
layout(binding = BITONIC_PAIRS, scalar) writeonly buffer Pairs { uvec2 pairs[]; };
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer PairsAt { uvec2 data[]; };

uvec2 loadPair(PairsAt pairsAt, uint i) { return kWideAddressing ? pairsAt.data[i] : texelFetch(pairsIn, int(i)).xy; }

void storePair(PairsAt pairsAt, uint i, uvec2 pair) {
  if (kWideAddressing)
    pairsAt.data[i] = pair;
  else
    pairs[i] = pair;
}
