"""Dynamics of the rigid body: an event-driven solver compiled by Numba, entered at `engine.run_batch`."""
