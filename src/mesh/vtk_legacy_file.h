// A file of VTK's legacy format: its header, and the words and arrays after it, one after the other.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "mesh/data_array.h"
#include "mesh/vtk_text.h"

namespace tetralux {

// All members throw Error(Input).
class VtkLegacyFile {
 public:
  // Reads the file and its three header lines.
  explicit VtkLegacyFile(const std::filesystem::path& path);
  VtkLegacyFile(const VtkLegacyFile&) = delete;
  VtkLegacyFile& operator=(const VtkLegacyFile&) = delete;

  // The file's name, for messages.
  const std::string& name() const { return name_; }
  bool isBinary() const { return isBinary_; }

  // Where the last word stands: "line 12", or "byte 4711" in a binary file.
  std::string location() const;

  // The next word in lower case; empty at the file's end.
  std::string keyword() { return lowerCase(scanner_.word()); }
  std::string peekKeyword() const { return lowerCase(scanner_.peekWord()); }

  // The next word, "%20" and the like decoded. `what` names it in the message where the file ends instead.
  std::string text(const char* what);

  // The next word as a whole number >= 0.
  size_t count(const char* what);

  // `tuples` x `components` numbers of a type, which begin on the next line of a binary file, with metadata after them
  // passed over. Nothing, after a warning, for bits and strings, which are passed over.
  //   place   begins messages
  std::optional<ArrayValues> values(std::string_view type, size_t tuples, size_t components, std::string_view place);

 private:
  void readHeader();
  void readBinary(size_t count, std::string_view place, ArrayValues& values);
  void passOverBits(size_t count, std::string_view place);
  void passOverStrings(size_t count, std::string_view place);
  void passOverMetadata();
  std::string_view bytes(size_t size, std::string_view place);

  std::string name_;
  std::string file_;
  TextScanner scanner_;
  bool isBinary_ = false;
};

}  // namespace tetralux
