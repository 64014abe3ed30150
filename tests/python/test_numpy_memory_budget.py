"""The memory budget: form, refusal with the least figure, both forms answer all queries and can be saved."""

from __future__ import annotations

import re

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid


def test_delta_asks_for_a_graph_and_both_forms_agree(tmp_path):
    vertices, faces = bent_grid(40, 36)
    tables = vorogeo.GeodesicIndex(vertices, faces, patches=(5, 4))
    graph = vorogeo.GeodesicIndex(vertices, faces, patches=(5, 4), delta=0.001)
    assert tables.statistics.form == "tables"
    assert graph.statistics.form == "graph"
    assert graph.statistics.arcs < tables.statistics.arcs
    field = graph.distance_field(7)
    np.testing.assert_allclose(field, tables.distance_field(7), rtol=0.02)
    graph.save(tmp_path / "graph.vgi")
    loaded = vorogeo.GeodesicIndex.load(tmp_path / "graph.vgi", vertices, faces)
    assert loaded.statistics.form == "graph"
    np.testing.assert_array_equal(loaded.distance_field(7), field)
    assert loaded.distance(3, 1200) == graph.distance(3, 1200)


def test_a_budget_that_is_too_small_names_the_least():
    vertices, faces = bent_grid(90, 80)
    index = vorogeo.GeodesicIndex(vertices, faces)
    needed = -(-index.statistics.bytes // 2**20)
    assert vorogeo.GeodesicIndex(vertices, faces, memory_budget=needed).statistics.form == "tables"
    with pytest.raises(vorogeo.InvalidInput, match="The memory budget is 1 MiB") as refusal:
        vorogeo.GeodesicIndex(vertices, faces, memory_budget=1)
    least = int(re.search(r"takes (?:at least|more than) (\d+) MiB", str(refusal.value)).group(1))
    assert 1 < least <= needed
    for wrong in (0, -5, 1.5, "much"):
        with pytest.raises(vorogeo.InvalidInput, match="memory_budget"):
            vorogeo.GeodesicIndex(vertices, faces, memory_budget=wrong)
