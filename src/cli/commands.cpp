#include "cli/commands.h"

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <chrono>
#include <cstdio>
#include <new>

#include "base/error.h"

namespace tetralux::cli {
namespace {

const std::chrono::steady_clock::time_point programStart = std::chrono::steady_clock::now();

// Log lines go to standard error: standard output is for results.
void setUpLogging() {
  spdlog::set_default_logger(spdlog::stderr_color_mt("tetralux"));
  spdlog::set_pattern("tetralux: %^%l%$: %v");
}

int reportError(const std::string& message, int status) {
  fmt::print(stderr, "tetralux: {}\n", message);
  return status;
}

// The first argument must name a command; said here because the parser's own message does not name the candidates.
void checkCommandName(int argc, const char* const* argv) {
  std::string names;
  for (const CommandEntry& entry : commandTable()) {
    if (argc > 1 && (entry.name == std::string_view(argv[1]) || argv[1][0] == '-')) return;
    names += fmt::format("{}{}", names.empty() ? "" : ", ", entry.name);
  }
  const std::string found = argc > 1 ? fmt::format("found '{}'", argv[1]) : "missing";
  fail(ErrorCode::Usage, "command: {}, expected one of {} (see tetralux --help)", found, names);
}

// CLI11 puts hints on further lines.
std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

const char* versionString() { return TETRALUX_VERSION; }

double millisecondsSinceStart() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - programStart).count();
}

const std::vector<CommandEntry>& commandTable() {
  static const std::vector<CommandEntry> table = {
      {"render", "Draw a scene or a mesh on the device", makeRenderCommand},
      {"reference", "Draw a scene in double precision on the processor: the exact picture", makeReferenceCommand},
      {"compare", "How far two pictures are apart", makeCompareCommand},
      {"bench", "Time frames, with the camera turning", makeBenchCommand},
      {"chart", "Chart error against time, for many ways of drawing", makeChartCommand},
      {"mesh", "Write a generated mesh", makeMeshCommand},
      {"table", "Write a table that a method of integration looks into", makeTableCommand},
      {"info", "What a mesh file holds, and its defects", makeInfoCommand},
      {"stability", "Drive every method to where it fails, and map its errors", makeStabilityCommand},
      {"devices", "List the machine's Vulkan devices", makeDevicesCommand},
  };
  return table;
}

int runMain(int argc, const char* const* argv) {
  if (!spdlog::get("tetralux")) setUpLogging();
  CLI::App app("tetralux: pictures of scalar fields on tetrahedral meshes, with a known error");
  app.name("tetralux");
  app.set_version_flag("--version", fmt::format("tetralux {}", versionString()));
  app.require_subcommand(1);
  app.failure_message([](const CLI::App*, const CLI::Error& e) { return std::string(e.what()); });
  std::vector<std::unique_ptr<Command>> commands;
  Command* chosen = nullptr;
  for (const CommandEntry& entry : commandTable()) {
    CLI::App* sub = app.add_subcommand(entry.name, entry.summary);
    sub->get_formatter()->column_width(36);
    commands.push_back(entry.make(*sub));
    sub->callback([&chosen, command = commands.back().get()] { chosen = command; });
  }
  try {
    checkCommandName(argc, argv);
    app.parse(argc, argv);
    return chosen->run();
  } catch (const CLI::Success& e) {  // --help, --version
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    return reportError(fmt::format("{} (see tetralux --help)", firstLine(e.what())),
                       static_cast<int>(ErrorCode::Usage));
  } catch (const Error& e) {
    return reportError(e.what(), static_cast<int>(e.code()));
  } catch (const std::bad_alloc&) {
    return reportError("out of memory", static_cast<int>(ErrorCode::Device));
  } catch (const std::exception& e) {
    return reportError(fmt::format("defect in tetralux, please report: {}", firstLine(e.what())), 70);
  }
}

}  // namespace tetralux::cli
