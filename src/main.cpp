#include "base/memory.h"
#include "cli/commands.h"

int main(int argc, char** argv) {
  tetralux::keepFreedMemory();
  return tetralux::cli::runMain(argc, argv);
}
