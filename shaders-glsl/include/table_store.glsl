// Packs a table's entries into the words of its format. An invocation stores four numbers: an entry of a table of four
// channels, or four entries next to each other of a table of one.
//
// Before including: TABLE_WORDS is a binding number; shared/spec_ids.h, shared/integration.h.
layout(constant_id = SPEC_TABLE_FORMAT) const uint kTableFormat = TABLE_F32;

layout(binding = TABLE_WORDS, scalar) writeonly buffer TableWords { uint tableWords[]; };

void storeFour(uint index, vec4 value) {
  if (kTableFormat == TABLE_UNORM8) {
    tableWords[index] = packUnorm4x8(value);
  } else if (kTableFormat == TABLE_UNORM16) {
    tableWords[2 * index] = packUnorm2x16(value.xy);
    tableWords[2 * index + 1] = packUnorm2x16(value.zw);
  } else if (kTableFormat == TABLE_F16) {
    tableWords[2 * index] = packHalf2x16(value.xy);
    tableWords[2 * index + 1] = packHalf2x16(value.zw);
  } else {
    for (uint i = 0; i < 4; i++) tableWords[4 * index + i] = floatBitsToUint(value[i]);
  }
}
