// A double as the sum of two floats.
#pragma once

namespace tetralux {

// What rounding to float leaves of a number.
inline float restOfFloat(double value) {
  // Through memory: GCC 12 takes a conversion to float and back for nothing where it sees both.
  volatile float rounded = static_cast<float>(value);
  return static_cast<float>(value - static_cast<double>(rounded));
}

}  // namespace tetralux
