"""Median overturning capacity of bare furniture by simulation, beside Kaneko and Hayashi's formula."""
