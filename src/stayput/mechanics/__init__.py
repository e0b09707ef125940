"""How a body moves: small compiled functions, scalars in and out (`engine.run_batch` ties them together)."""
