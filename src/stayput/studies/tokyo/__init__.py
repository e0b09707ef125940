"""The Tokyo Metropolitan Government's product test of 2015, simulated with stated parameters."""
