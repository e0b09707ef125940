"""What is inside furniture: what slides, topples and comes out of its shelves as the piece itself moves."""

from __future__ import annotations

from stayput.contents.contents import CONTENTS, Contents, ContentsKind

__all__ = ["CONTENTS", "Contents", "ContentsKind"]
