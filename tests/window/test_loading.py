"""What was seen when the plugin was loaded by MeshLab's dialog, and when it was installed for one user."""

from __future__ import annotations

import pytest
from results import written_down
from test_window import all_filters


@pytest.fixture(scope="module")
def extra_folder() -> dict:
    """What extra_folder.py saw."""
    return written_down("extra_folder")


def test_load_plugins_adds_every_filter_to_the_menu(seen):
    assert seen["before"] == []
    assert set(seen["after"]) == all_filters()


def test_a_filter_of_a_loaded_plugin_is_applied(seen):
    assert seen["applied"] == ""
    assert f"Start: vertex {seen['source']}" in seen["log"]
    assert seen["alive"] is True


def test_plugin_installed_for_one_user_is_found_and_applied(extra_folder):
    assert set(extra_folder["filters"]) == all_filters()
    assert extra_folder["applied"] == ""
    assert f"Start: vertex {extra_folder['source']}" in extra_folder["log"]
    assert extra_folder["alive"] is True
