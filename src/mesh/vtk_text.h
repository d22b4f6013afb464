// Words and numbers in the text of VTK files.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "mesh/data_array.h"

namespace tetralux {

// Takes words and lines, one after the other, from a text that may have binary parts.
class TextScanner {
 public:
  explicit TextScanner(std::string_view text) : text_(text) {}

  // The next run of characters that are not white space; empty at the end.
  std::string_view word();
  // The same, without taking it.
  std::string_view peekWord() const;

  // The rest of the line, without its end ("\n" or "\r\n"), which is taken too.
  std::string_view line();

  // The next `count` <= remaining() bytes.
  std::string_view bytes(size_t count);

  size_t position() const { return position_; }
  size_t remaining() const { return text_.size() - position_; }
  bool atEnd() const { return position_ == text_.size(); }

  // Number of the line that the last word taken stands in, from 1. Counts from the beginning: for messages.
  size_t lineNumber() const;

 private:
  std::string_view text_;
  size_t position_ = 0;
};

// The whole of `word` as a number of type T: an arithmetic type that is not bool. "nan", "inf" and a leading '+' are
// understood. False where it is none or does not fit T; a magnitude too small for float becomes zero or denormal.
template <typename T>
bool parseNumber(std::string_view word, T& value);

// Replaces `values` by `count` numbers of its type, read from the scanner's next words.
// Throws Error(Input), beginning with `place`, when the text holds fewer or something else.
void readNumbers(TextScanner& scanner, size_t count, std::string_view place, ArrayValues& values);

// ASCII letters in lower case.
std::string lowerCase(std::string_view text);

// The text with control characters as blanks: for warnings with names from a file (an Error does it by itself).
std::string oneLine(std::string_view text);

// What a message quotes of a file: at most 40 characters, those that cannot be printed as '.'.
std::string excerpt(std::string_view text);

}  // namespace tetralux
