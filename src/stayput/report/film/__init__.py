"""Films of runs: scenes, frames and a player."""
