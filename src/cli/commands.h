// The command line: a table of commands, and what becomes of their errors.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

namespace tetralux::cli {

// One command. Options are declared in the constructor on the sub-application it is given; run() does the work and
// returns the exit status. Errors are thrown.
class Command {
 public:
  virtual ~Command() = default;
  virtual int run() = 0;
};

struct CommandEntry {
  const char* name;
  const char* summary;
  std::unique_ptr<Command> (*make)(CLI::App& app);
};

// All commands, in the order that --help lists them.
const std::vector<CommandEntry>& commandTable();

// Runs the command line and returns the exit status: 0 done, 1 a limit that was asked for was missed, 2 bad usage,
// 3 bad input file, 4 no usable device or out of memory, 5 output could not be written. Errors are one line on standard
// error: "tetralux: place: value found, value expected".
int runMain(int argc, const char* const* argv);

const char* versionString();

// Milliseconds since the program started.
double millisecondsSinceStart();

std::unique_ptr<Command> makeRenderCommand(CLI::App& app);
std::unique_ptr<Command> makeReferenceCommand(CLI::App& app);
std::unique_ptr<Command> makeCompareCommand(CLI::App& app);
std::unique_ptr<Command> makeBenchCommand(CLI::App& app);
std::unique_ptr<Command> makeChartCommand(CLI::App& app);
std::unique_ptr<Command> makeMeshCommand(CLI::App& app);
std::unique_ptr<Command> makeTableCommand(CLI::App& app);
std::unique_ptr<Command> makeInfoCommand(CLI::App& app);
std::unique_ptr<Command> makeStabilityCommand(CLI::App& app);
std::unique_ptr<Command> makeDevicesCommand(CLI::App& app);

}  // namespace tetralux::cli
