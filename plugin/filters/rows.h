// All filters, in the order in which the host lists them, and their help.
#pragma once

#include <QString>
#include <vector>

#include "host/filter_row.h"

namespace vorogeo::plugin {

// ---- Paragraphs of help text that several filters share, in the HTML subset that the host shows

/// When an index is built, and that it is reused until the mesh is edited.
QString help_on_index();
/// How to choose parameters of a distance field from the index.
QString help_on_choosing();
/// Where a task takes its points from; and its parameter exact, and the index that it uses otherwise.
QString help_on_task_points();
QString help_on_exact_parameter();
/// The papers on the method of the index, and on exact distances.
QString references_of_index();
QString reference_of_exact();

// ---- The table of all filters: one row each, made in the file of the filter

std::vector<FilterRow> index_rows();
std::vector<FilterRow> distance_rows();
std::vector<FilterRow> path_rows();
std::vector<FilterRow> matrix_rows();
std::vector<FilterRow> region_rows();
std::vector<FilterRow> sampling_rows();
std::vector<FilterRow> comparison_rows();

/// In the order in which the host lists them.
std::vector<FilterRow> all_rows();

}  // namespace vorogeo::plugin
