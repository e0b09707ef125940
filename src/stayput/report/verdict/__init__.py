"""The report of a verdict: HTML, Markdown, JSON and CSV, in English and Japanese."""

from __future__ import annotations
