// Random numbers by index: the same on every machine, whatever the order or the thread they are asked in.
#pragma once

#include <cstdint>

namespace tetralux {

// 64 well mixed bits (the output function of SplitMix64; Steele, Lea, Flood 2014, "Fast splittable pseudorandom
// number generators").
inline std::uint64_t mixBits(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
  return bits ^ (bits >> 31);
}

// The `index`-th number of the sequence `seed`, uniform in [0, 1), a multiple of 2^-53.
inline double randomUnit(std::uint64_t seed, std::uint64_t index) {
  constexpr std::uint64_t kGoldenGamma = 0x9e3779b97f4a7c15u;  // 2^64 / golden ratio: SplitMix64's increment
  const std::uint64_t bits = mixBits(mixBits(seed + kGoldenGamma) + (index + 1) * kGoldenGamma);
  return static_cast<double>(bits >> 11) * 0x1p-53;
}

}  // namespace tetralux
