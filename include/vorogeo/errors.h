// The errors of VoroGeo: each message names the element that is wrong and says what to do.
#pragma once

#include <stdexcept>

#if defined(__GNUC__) && !defined(_WIN32)
#define VOROGEO_API __attribute__((visibility("default")))
#else
#define VOROGEO_API
#endif

namespace vorogeo {
// Part of the name of every symbol: a program that was compiled with another interface does not link with it.
inline namespace v0 {

/// Base of all errors of the library.
class VOROGEO_API Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};
/// An argument or a mesh that cannot be used.
class VOROGEO_API InvalidInput : public Error {
 public:
  using Error::Error;
};
/// An index file that is missing, damaged, of another version or of another mesh.
class VOROGEO_API IndexFileError : public Error {
 public:
  using Error::Error;
};
/// A result that needs more memory than there is; says how much.
class VOROGEO_API NotEnoughMemory : public Error {
 public:
  using Error::Error;
};
/// A progress function returned false; nothing was changed.
class VOROGEO_API Cancelled : public Error {
 public:
  Cancelled() : Error("Cancelled: nothing was changed.") {}
};

}  // namespace v0
}  // namespace vorogeo
