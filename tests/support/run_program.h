// Runs the program as a user would.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace tetralux::test {

struct ProgramResult {
  int status = -1;  // exit status; -1 when it was killed
  std::string out;
  std::string err;
};

inline std::string shellQuoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

// Arguments are passed as they are; `environment` is put before the command ("NAME=value").
inline ProgramResult runTetralux(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                                 const std::string& environment = "") {
  const std::filesystem::path errors = folder / ".stderr";
  std::string command = "cd " + shellQuoted(folder.string()) + " && " + environment + " " TETRALUX_PROGRAM;
  for (const std::string& a : arguments) command += " " + shellQuoted(a);
  command += " 2>" + shellQuoted(errors.string());
  ProgramResult result;
  std::FILE* pipe = ::popen(command.c_str(), "r");
  std::array<char, 4096> block;
  size_t got = 0;
  while ((got = std::fread(block.data(), 1, block.size(), pipe)) > 0) result.out.append(block.data(), got);
  const int wait = ::pclose(pipe);
  result.status = WIFEXITED(wait) ? WEXITSTATUS(wait) : -1;
  if (std::FILE* file = std::fopen(errors.c_str(), "r")) {
    while ((got = std::fread(block.data(), 1, block.size(), file)) > 0) result.err.append(block.data(), got);
    std::fclose(file);
    std::filesystem::remove(errors);
  }
  return result;
}

}  // namespace tetralux::test
