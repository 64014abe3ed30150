// Paragraphs of help text that several filters share, in the HTML subset that the host shows.
#pragma once

#include <QString>

namespace vorogeo::plugin {

/// What the index is, and that it follows the mesh.
QString help_on_index();
/// What ends up in quality and colour, and which vertices get -1.
QString help_on_field();
/// How to choose parameters of a distance field from the index.
QString help_on_choosing();
/// What exact means, and when to prefer the index.
QString help_on_exact();
/// Where a task takes its points from, and its parameter exact.
QString help_on_task_points();
QString help_on_exact_parameter();
/// The papers: the index method, and those of the exact solver.
QString references_of_index();
QString references_of_exact();

}  // namespace vorogeo::plugin
