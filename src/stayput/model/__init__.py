"""What stands, and where: bodies, rooms, presets of furniture, the initial state."""
