"""What all frames of films share."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from stayput.report.film import Film
from stayput.report.frames import FrameLayout

SHORT, LONG = "the north component of a record with a long name.csv", "地震の揺れの記録の名前" * 12


@pytest.mark.parametrize("text", ["", SHORT, 4 * f"{SHORT}, ", LONG])
def test_texts_of_any_length_are_within_the_frame(text: str):
    film = Film(SimpleNamespace(start=0.0, end=10.0), "", text, text, "en", "")  # type: ignore[type-var]
    layout = FrameLayout(film, {"x": np.zeros(2)}, np.array([0.0, 10.0]), 640, 480)
    left, top, right, bottom = layout._strip
    heading, caption = layout._heading, layout._caption
    assert all(heading.face.getlength(line) <= right - left for line in heading.text.splitlines())
    assert all(caption.face.getlength(line) <= 640 for line in caption.text.splitlines())
    assert 40 + layout.scene[1] / 2 <= top - heading.height
    assert bottom + caption.height < 480
