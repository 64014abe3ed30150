// The vectorised kernels once more, compiled for the plainest instruction set, under another namespace.
#define VOROGEO_NO_CLONES
#define vorogeo vorogeo_scalar
#include "index/scans.cpp"
