"""What was seen after random steps in MeshLab's window: no crash, no stale answer, a sentence where one is refused."""

from __future__ import annotations

import numpy as np
import vorogeo
from test_window import saved_mesh


def test_distances_are_those_of_the_mesh_as_it_was_saved(seen):
    for sequence in seen["sequences"]:
        vertices, faces, quality = saved_mesh(sequence["field"])
        exact = vorogeo.exact_distance_field(vertices, faces, [sequence["source"]])
        others = (exact > 0) & np.isfinite(exact)
        errors = np.abs(quality[others] / exact[others] - 1)
        seed = f"seed {sequence['seed']}: {sequence['boxes']}"
        assert errors.max() < (1e-5 if sequence["exact"] else 0.05), seed
        assert errors.mean() < (1e-6 if sequence["exact"] else 5e-4), seed
        assert quality[sequence["source"]] == 0, seed


def test_boxes_name_the_wrong_number_and_there_are_no_others(seen):
    for sequence in seen["sequences"]:
        for name, box in sequence["boxes"]:
            seed = f"seed {sequence['seed']}: {name}: {box}"
            if name == "wrong":
                assert '"Start vertex" (vertex_index) is ' in box, seed
            else:
                assert box == "", seed


def test_meshlab_goes_on(seen):
    assert seen["alive"] is True
