"""The report of a verdict on a room: one HTML file with its plan, in English and Japanese."""

from __future__ import annotations

from stayput.report.room.html import write_report

__all__ = ["write_report"]
