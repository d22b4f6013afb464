// The list of a pixel's entries, kept in order.
//
// Before including: march_bindings.glsl.

// Rank of the next face in a list; none: beyond all.
uint rankOf(uint node) { return node == NO_NODE ? 0xffffffffu : pixelRanks[node].x; }

// Takes the first node out of a list and puts it back where its rank belongs. Returns the new first node.
uint putBack(uint node) {
  const uint rank = pixelRanks[node].x;
  const uint head = pixelLinks[node];
  uint last = head;
  for (uint i = 0; i < kLongestList; i++) {
    const uint next = pixelLinks[last];
    if (rankOf(next) >= rank) break;
    last = next;
  }
  pixelLinks[node] = pixelLinks[last];
  pixelLinks[last] = node;
  return head;
}
