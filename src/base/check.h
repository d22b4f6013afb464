// Conditions that only a defect in tetralux can break. Active in every build; the values are printed.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace tetralux {

// A broken CHECK: never caused by input, always a defect here.
class CheckFailure : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

[[noreturn]] inline void checkFailed(const char* file, int line, const std::string& what) {
  throw CheckFailure(fmt::format("{}:{}: check failed: {}", file, line, what));
}

}  // namespace tetralux

#define CHECK(condition)                                                       \
  do {                                                                         \
    if (!(condition)) ::tetralux::checkFailed(__FILE__, __LINE__, #condition); \
  } while (false)

#define CHECK_OP_(a, op, b)                                                                           \
  do {                                                                                                \
    const auto& checkA_ = (a);                                                                        \
    const auto& checkB_ = (b);                                                                        \
    if (!(checkA_ op checkB_))                                                                        \
      ::tetralux::checkFailed(__FILE__, __LINE__,                                                     \
                              fmt::format("{} {} {}: {} against {}", #a, #op, #b, checkA_, checkB_)); \
  } while (false)

#define CHECK_EQ(a, b) CHECK_OP_(a, ==, b)
#define CHECK_LE(a, b) CHECK_OP_(a, <=, b)
#define CHECK_LT(a, b) CHECK_OP_(a, <, b)
