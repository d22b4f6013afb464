// Cells that wait for others with which they share no face: a list for every cell of those that wait for it.
//
// Before including: buffers waiting, relationHeads, relations, status; addresses waitingAt, relationHeadsAt; relationCapacity.

uint relationHead(uint cell) { return kWideAddressing ? relationHeadsAt.data[cell] : relationHeads[cell]; }

void countRelation(uint front, uint behind) {
  if (kWideAddressing) {
    atomicAdd(waitingAt.data[front], 1u);
    atomicOr(waitingAt.data[behind], WAIT_RELATED);
  } else {
    atomicAdd(waiting[front], 1u);
    atomicOr(waiting[behind], WAIT_RELATED);
  }
}

// Whether a list begins with the cell, within a few nodes.
bool isKnown(uint node, uint cell) {
  bool found = false;
  for (uint i = 0; i < 8u; i++) {
    if (node == NO_NODE || found) break;
    found = relations[node].cell == cell;
    node = relations[node].next;
  }
  return found;
}

// `front` waits for `behind`. Many pixels find the same pair; a few nodes are looked at to leave it out. Should it be there twice,
// it is waited for and released twice. Nodes are all ones before they are written: whoever meets a new one sees no cell, or a
// list that ends there.
void addRelation(uint front, uint behind) {
  if (isKnown(relationHead(behind), front)) return;
  const uint node = atomicAdd(status.relations, 1u);
  if (node >= relationCapacity) return;
  relations[node].cell = front;
  relations[node].next = kWideAddressing ? atomicExchange(relationHeadsAt.data[behind], node)
                                         : atomicExchange(relationHeads[behind], node);
  countRelation(front, behind);
}

