// The errors that leave the core: each message names the offending element and what to do.
#pragma once

#include <stdexcept>
#include <string>

namespace vorogeo {

/// Base of every error thrown on purpose by the core.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An argument or a mesh that cannot be used; the message names the element.
class InvalidInput : public Error {
 public:
  using Error::Error;
};

/// An index file that is missing, truncated, damaged, of another version or of another mesh.
class IndexFileError : public Error {
 public:
  using Error::Error;
};

/// The caller's progress function asked to stop; nothing was changed.
class Cancelled : public Error {
 public:
  Cancelled() : Error("Cancelled: nothing was changed.") {}
};

}  // namespace vorogeo
