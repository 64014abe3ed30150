// What a call is refused with.
#pragma once

#include <string>

#include "support/error.h"

namespace vorogeo::test {

/// The sentence with which a call is refused with an error of this kind; empty if it is not.
template <class Kind = InvalidInput, class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const Kind& error) {
    return error.what();
  }
  return {};
}

}  // namespace vorogeo::test
