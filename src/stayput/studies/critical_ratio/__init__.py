"""The critical aspect ratio for overturning (the paper, §4.3)."""
