// Lists of fragments, one for every pixel of a band of rows (shared/pixel_lists.h).
//
// Before including: PIXEL_HEADS, PIXEL_LINKS, PIXEL_RANKS are binding numbers.
layout(binding = PIXEL_HEADS, scalar) coherent buffer PixelHeads { uint pixelHeads[]; };  // first node of each pixel
layout(binding = PIXEL_LINKS, scalar) buffer PixelLinks { uint pixelLinks[]; };           // next node of each node
layout(binding = PIXEL_RANKS, scalar) buffer PixelRanks { uvec2 pixelRanks[]; };          // what nodes are sorted by

// Lists longer than this are not sorted to their end: devices may end longer loops by themselves.
const uint kLongestList = 65535u;

bool precedes(uvec2 a, uvec2 b) { return a.x < b.x || (a.x == b.x && a.y <= b.y); }

// Floats as integers of the same order.
uint orderedFloat(float value) {
  const uint bits = floatBitsToUint(value);
  return (bits >> 31) != 0u ? ~bits : bits | 0x80000000u;
}

// Cuts a list behind its first run of ascending nodes; returns the rest.
uint cutRun(uint head) {
  uint last = head;
  uint next = pixelLinks[last];
  for (uint i = 0; i < kLongestList; i++) {
    if (next == NO_NODE || !precedes(pixelRanks[last], pixelRanks[next])) break;
    last = next;
    next = pixelLinks[last];
  }
  pixelLinks[last] = NO_NODE;
  return next;
}

// The list turned round.
uint reversedList(uint head) {
  uint reversed = NO_NODE;
  for (uint i = 0; i < kLongestList; i++) {
    if (head == NO_NODE) break;
    const uint next = pixelLinks[head];
    pixelLinks[head] = reversed;
    reversed = head;
    head = next;
  }
  return reversed;
}

// Sorts a list by ascending rank in place; returns its first node. A natural merge sort (Knuth 1973, section 5.2.4): what
// arrived in order costs one walk.
uint sortedList(uint head) {
  head = reversedList(head);  // nodes are put in at the front
  for (uint pass = 0; pass < 32u; pass++) {
    uint rest = head;
    uint first = NO_NODE;
    uint last = NO_NODE;
    bool isSorted = true;
    for (uint pair = 0; pair < kLongestList; pair++) {
      if (rest == NO_NODE) break;
      uint a = rest;
      uint b = cutRun(a);
      rest = b == NO_NODE ? NO_NODE : cutRun(b);
      isSorted = isSorted && b == NO_NODE;
      for (uint i = 0; i < kLongestList; i++) {
        if (a == NO_NODE && b == NO_NODE) break;
        const bool takeA = b == NO_NODE || (a != NO_NODE && precedes(pixelRanks[a], pixelRanks[b]));
        const uint node = takeA ? a : b;
        if (takeA)
          a = pixelLinks[a];
        else
          b = pixelLinks[b];
        if (last == NO_NODE)
          first = node;
        else
          pixelLinks[last] = node;
        last = node;
      }
    }
    head = first;
    if (isSorted) break;
  }
  return head;
}

// A node of a short list, with what it is sorted by.
struct RankedNode {
  uint node;
  uvec2 rank;
};

RankedNode rankedNode(uint node) {
  return RankedNode(node, node == NO_NODE ? uvec2(0xffffffffu) : pixelRanks[node]);
}

uint nextNode(uint node) { return node == NO_NODE ? NO_NODE : pixelLinks[node]; }

void putInOrder(inout RankedNode a, inout RankedNode b) {
  if (!precedes(b.rank, a.rank)) return;
  const RankedNode first = b;
  b = a;
  a = first;
}

// The same as sortedList() of a list of up to eight nodes, which most are: in registers, by a network of 19 exchanges (Batcher 1968).
// Longer lists are left to sortedList().
uint sortedShortList(uint head) {
  RankedNode n[8];
  n[0] = rankedNode(head);
  n[1] = rankedNode(nextNode(n[0].node));
  n[2] = rankedNode(nextNode(n[1].node));
  n[3] = rankedNode(nextNode(n[2].node));
  n[4] = rankedNode(nextNode(n[3].node));
  n[5] = rankedNode(nextNode(n[4].node));
  n[6] = rankedNode(nextNode(n[5].node));
  n[7] = rankedNode(nextNode(n[6].node));
  if (nextNode(n[7].node) != NO_NODE) return sortedList(head);
  putInOrder(n[0], n[1]); putInOrder(n[2], n[3]); putInOrder(n[4], n[5]); putInOrder(n[6], n[7]);
  putInOrder(n[0], n[2]); putInOrder(n[1], n[3]); putInOrder(n[4], n[6]); putInOrder(n[5], n[7]);
  putInOrder(n[1], n[2]); putInOrder(n[5], n[6]); putInOrder(n[0], n[4]); putInOrder(n[1], n[5]);
  putInOrder(n[2], n[6]); putInOrder(n[3], n[7]); putInOrder(n[2], n[4]); putInOrder(n[3], n[5]);
  putInOrder(n[1], n[2]); putInOrder(n[3], n[4]); putInOrder(n[5], n[6]);
  if (n[0].node != NO_NODE) pixelLinks[n[0].node] = n[1].node;
  if (n[1].node != NO_NODE) pixelLinks[n[1].node] = n[2].node;
  if (n[2].node != NO_NODE) pixelLinks[n[2].node] = n[3].node;
  if (n[3].node != NO_NODE) pixelLinks[n[3].node] = n[4].node;
  if (n[4].node != NO_NODE) pixelLinks[n[4].node] = n[5].node;
  if (n[5].node != NO_NODE) pixelLinks[n[5].node] = n[6].node;
  if (n[6].node != NO_NODE) pixelLinks[n[6].node] = n[7].node;
  if (n[7].node != NO_NODE) pixelLinks[n[7].node] = NO_NODE;
  return n[0].node;
}
