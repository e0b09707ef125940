"""Make the machine code that a wheel brings, for the usual processors of this machine's family.

Run it with the package's sources before the wheel is built: ``python .ci/machine_code.py``.
"""

from __future__ import annotations

import os
import shutil
import tempfile
from pathlib import Path

import numpy as np

import stayput as sp
from stayput.compiling.machine_code import WITH_PACKAGE
from stayput.motion.intensity import long_period_response


def call_all() -> None:
    """Call each compiled function, with arguments of all the types with which the package calls it."""
    motion = sp.Motion(0.01, 2.0 * np.sin(np.linspace(0.0, 20.0, 400)))
    body, room = sp.Body(0.3, 1.8, 100.0, length=0.9), sp.Room(left_wall=sp.Wall(0.02))
    for measures in ([], [sp.MEASURES["belt"]()]):
        sp.simulate(body, room, motion, measures=measures, dimensions=2)
    sp.simulate(body, room, motion, dimensions=3)
    motion.spectrum()
    long_period_response(motion.x, None, motion.dt)
    for nonlinear in (False, True):
        sp.Building(3, nonlinear=nonlinear).floor_motion(motion, 3)


def main() -> None:
    """Compile all anew and put it where `stayput.compiling.machine_code` looks for what comes with it."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["NUMBA_CACHE_DIR"] = folder
        call_all()
        WITH_PACKAGE.mkdir(exist_ok=True)
        for file in Path(folder).rglob("*.code"):
            shutil.copy(file, WITH_PACKAGE)
            print(WITH_PACKAGE / file.name)


if __name__ == "__main__":
    main()
