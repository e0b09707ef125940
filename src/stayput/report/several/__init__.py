"""Reports of verdicts on several pieces: HTML, Markdown, JSON and CSV."""
