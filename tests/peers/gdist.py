"""What gdist's own tests import: vorogeo.compat.gdist under the name of the package it stands for."""

from vorogeo.compat.gdist import compute_gdist, distance_matrix_of_selected_points, local_gdist_matrix

__all__ = ["compute_gdist", "distance_matrix_of_selected_points", "local_gdist_matrix"]
