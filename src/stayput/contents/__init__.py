"""What is inside furniture: what slides, topples and comes out of its shelves as the piece itself moves."""

from __future__ import annotations

from stayput.contents.contents import Contents
from stayput.contents.kinds import CONTENTS, ContentsKind

__all__ = ["CONTENTS", "Contents", "ContentsKind"]
