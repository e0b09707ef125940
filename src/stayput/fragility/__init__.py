"""Probability and capacity from counted falls: pure functions of numbers, nothing is simulated here."""
