// How much memory a result may take, checked before it is allocated.
#pragma once

#include <cstdint>
#include <string>

#include "support/error.h"

namespace vorogeo {

/// The message for an allocation that failed midway, when nothing more is known.
inline constexpr const char* out_of_memory_sentence =
    "There is not enough memory for this computation on this mesh. Close other programs, use fewer threads, "
    "or use a smaller mesh.";

/// Bytes that this process can still take without swapping: what the system calls available, or what the
/// control group of the process or its limit of address space (ulimit -v) leaves if that is less. A very
/// large number where the system does not say.
std::int64_t available_memory_bytes();

/// Throws NotEnoughMemory if `needed` bytes are more than `max_bytes`; 0 stands for the available memory.
/// `what` begins the sentence ("The matrix of 5 x 5 distances"), `advice` ends it ("Give fewer points.").
void require_memory(double needed, std::int64_t max_bytes, const std::string& what,
                    const std::string& advice);

}  // namespace vorogeo
