// The scans over bounds once more, compiled for the plainest instruction set, under another namespace.
#define VOROGEO_NO_CLONES
#define vorogeo vorogeo_scalar
#include "index/bound_scans.cpp"
