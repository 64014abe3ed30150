// What a call is refused with.
#pragma once

#include <string>

#include "support/error.h"

namespace vorogeo::test {

/// The sentence with which a call is refused as invalid input; empty if it is not.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return {};
}

}  // namespace vorogeo::test
