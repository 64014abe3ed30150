// Digit by digit, from the highest: the bits of positive numbers are in the order of the numbers.
#include "support/positive_rank.h"

#include <cstdint>
#include <cstring>
#include <vector>

#include "support/progress.h"

namespace vorogeo {

double positive_of_rank(std::span<const double> values, std::size_t rank) {
  constexpr int bits_per_digit = 16;
  constexpr std::size_t digits = std::size_t{1} << bits_per_digit;
  std::uint64_t prefix = 0;
  for (int shift = 64 - bits_per_digit; shift >= 0; shift -= bits_per_digit) {
    std::vector<std::size_t> counts(digits, 0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i % elements_per_checkpoint == 0) checkpoint();
      std::uint64_t bits;
      std::memcpy(&bits, &values[i], sizeof(bits));
      if (!(values[i] > 0.0) || ((bits ^ prefix) >> shift >> bits_per_digit) != 0) continue;
      ++counts[(bits >> shift) % digits];
    }
    std::uint64_t digit = 0;
    while (rank >= counts[digit]) rank -= counts[digit++];
    prefix |= digit << shift;
  }
  double value;
  std::memcpy(&value, &prefix, sizeof(value));
  return value;
}

}  // namespace vorogeo
