"""What all frames of films share."""

from __future__ import annotations

import pytest

from stayput.report.layout import FrameLayout

SHORT, LONG = "the north component of a record with a long name.csv", "地震の揺れの記録の名前" * 12


@pytest.mark.parametrize("text", ["", SHORT, 4 * f"{SHORT}, ", LONG])
def test_texts_of_any_length_are_within_the_frame(text: str):
    layout = FrameLayout(640, 480, 0.0, 10.0, text, text)
    left, top, right, bottom = layout._strip
    heading, caption = layout._heading, layout._caption
    assert all(heading.face.getlength(line) <= right - left for line in heading.text.splitlines())
    assert all(caption.face.getlength(line) <= 640 for line in caption.text.splitlines())
    assert 40 + layout.scene[1] / 2 <= top - heading.height
    assert bottom + caption.height < 480
