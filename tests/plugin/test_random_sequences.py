"""A few random sequences of clicks, from other seeds each time: random_sequences.py, which runs as many as wanted."""

from __future__ import annotations

import numpy as np
import random_sequences


def test_whatever_is_clicked_nothing_crashes_changes_or_is_out_of_date():
    first = int(np.random.SeedSequence().entropy % 2**31)
    findings, counts = random_sequences.run(first, 12)
    assert not findings, findings
    assert counts["answered"] > 0
    assert counts["refused"] > 0
    assert counts["fields compared"] > 0
