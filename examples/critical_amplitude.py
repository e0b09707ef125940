"""How strong must one sine wave be to overturn a block? Bisection, beside West's static threshold."""

import stayput as sp

block = sp.Body(width=0.4, height=1.2, mass=100.0)
rough = sp.Room(floor=sp.Floor(static_friction=2.0, kinetic_friction=2.0))


def overturns(amplitude: float) -> bool:
    """Simulate one wave of 1 s and a quiet time after it."""
    wave = sp.sine(amplitude, frequency=1.0, duration=1.0, quiet=6.0)
    return sp.simulate(block, rough, wave).overturned


low, high = 3.0, 30.0
assert not overturns(low)
assert overturns(high)
while high - low > 0.01:
    middle = 0.5 * (low + high)
    low, high = (low, middle) if overturns(middle) else (middle, high)

west = block.width / block.height * 9.80665
print(f"Rocking starts at {west:.2f} m/s², and a wave of {high:.2f} m/s² overturns the block")
assert west < high < 4.0 * west
