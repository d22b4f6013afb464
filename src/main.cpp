#include "cli/commands.h"

int main(int argc, char** argv) { return tetralux::cli::runMain(argc, argv); }
