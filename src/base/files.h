// Reading whole files, and writing files that appear complete or not at all.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace tetralux {

// The whole content of a regular file. Throws Error(Input) when it is missing, a directory, unreadable or empty.
std::vector<std::byte> readFile(const std::filesystem::path& path);

// The same as text.
std::string readTextFile(const std::filesystem::path& path);

// An output file under a temporary name beside its place, renamed by commit(). Without commit() nothing stays behind
// and an existing file of that name is untouched.
class PendingFile {
 public:
  // Reserves the temporary name. Throws Error(Output) when the folder is missing or cannot be written to, or when
  // `path` is a directory.
  explicit PendingFile(std::filesystem::path path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  const std::filesystem::path& temporaryPath() const { return temporary_; }

  // Renames the temporary file to its place. Throws Error(Output) when that fails.
  void commit();

 private:
  std::filesystem::path path_;
  std::filesystem::path temporary_;
  bool committed_ = false;
};

// Writes `size` bytes to `path`, complete or not at all. Throws Error(Output).
void writeFile(const std::filesystem::path& path, const void* bytes, size_t size);
void writeFile(const std::filesystem::path& path, const std::string& text);

}  // namespace tetralux
