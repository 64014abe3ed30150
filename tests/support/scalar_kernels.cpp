// The vectorised kernels once more, compiled for the plainest instruction set, under another namespace.
#define VOROGEO_NO_CLONES
#define vorogeo vorogeo_scalar
#include "index/crossing_gains.cpp"
#include "index/lane_sums.cpp"
#include "index/min_plus.cpp"
