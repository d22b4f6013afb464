// Keys and values of the radix sort: read through texel buffers, written through storage buffers, or both through
// addresses where they are longer than a descriptor reaches.
//
// Before including: SORT_KEYS_IN and SORT_VALUES_IN are binding numbers.
layout(constant_id = SPEC_WIDE_ADDRESSING) const bool kWideAddressing = false;
layout(constant_id = SPEC_FIRST_DIGIT) const bool kFirstDigit = false;

layout(binding = SORT_KEYS_IN) uniform usamplerBuffer keysIn;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer UintsAt { uint data[]; };

// Number of elements that a pass goes through: all cells in the first, those kept in the later ones.
uint elementCount(uint cellCount, uint kept) { return kFirstDigit ? cellCount : kept; }

uint loadKey(UintsAt keysAt, uint i) { return kWideAddressing ? keysAt.data[i] : texelFetch(keysIn, int(i)).x; }

// Culled cells take no part; the first pass drops them.
bool takesPart(uint key) { return !kFirstDigit || key < KEY_TRANSPARENT; }

uint digitOf(uint key, uint shift) { return (key >> shift) & (SORT_DIGITS - 1u); }
