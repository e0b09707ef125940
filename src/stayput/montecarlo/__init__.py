"""Monte Carlo core of verifications, inventories and the app's size map: draws, motions, runs and counts."""
