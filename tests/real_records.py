"""Where real records are, and the mark of tests that need them."""

from pathlib import Path

import pytest

MOTIONS = Path(__file__).parents[2] / "shared" / "motions"
recorded = pytest.mark.skipif(not MOTIONS.is_dir(), reason="the folder of real records is absent")
