// How long a thread has worked.
#pragma once

namespace vorogeo {

/// Seconds of the processor that the calling thread has had. Unlike a clock on the wall it stands still while
/// other programs run, so that two measured parts of work compare on a busy machine, too.
double thread_seconds();

}  // namespace vorogeo
