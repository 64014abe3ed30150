// Min-plus scans: the inner loops of tables, compiled for several instruction sets and chosen at run time.
#pragma once

#include "support/types.h"

namespace vorogeo {

/// Least a[i] + b[i] for i in [0, count); infinity for none.
float least_sum(const float* a, const float* b, Index count);

/// First i with a[i] + b[i] <= bound; no_index for none.
Index first_within(const float* a, const float* b, Index count, float bound);

/// First i in [begin, count) with base + line[i] < distance[i]; count for none.
Index first_lower(const float* line, double base, const double* distance, Index begin, Index count);

/// least[i] = min(least[i], base + line[i]); where that is lower, best[i] = name.
void lower_by_line(const float* line, float base, Index name, Index count, float* least, Index* best);

}  // namespace vorogeo
