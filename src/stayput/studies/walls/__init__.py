"""A body beside a wall, under a sine and under a record (the paper, §4.4 and §4.5)."""
