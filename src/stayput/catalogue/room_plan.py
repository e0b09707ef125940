"""Texts of the editor of a room's plan; its script fills in what stands in braces."""

SHARED = (
    "rooms.left_wall",
    "rooms.right_wall",
    "rooms.near_side_wall",
    "rooms.far_side_wall",
)
"""Texts of other modules that the editor says too; their keys there are their keys on the page."""

TEXTS: dict[str, tuple[str, str]] = {
    "roomPlan": ("The room", "部屋"),
}
"""Texts by their keys: English, Japanese."""
