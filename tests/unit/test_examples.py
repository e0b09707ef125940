"""Every example runs: the scripts with their own asserts, the scenario files to an outcome."""

import runpy
from pathlib import Path

import pytest

import stayput as sp

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("script", sorted(EXAMPLES.glob("*.py")), ids=lambda path: path.stem)
def test_script(script):
    runpy.run_path(str(script), run_name="__main__")


SEVERAL, ROOMS = {"dresser", "television"}, {"bedroom"}
"""Files of several pieces, and of rooms."""


@pytest.mark.parametrize("file", sorted(EXAMPLES.glob("*.toml")), ids=lambda path: path.stem)
def test_scenario_file(file):
    if file.stem in ROOMS:
        run = sp.read_room(file).run()
    elif file.stem in SEVERAL:
        run = sp.read_assembly(file).run()
    else:
        run = sp.read_scenario(file).case().run()
    assert run.outcome is not sp.Outcome.FAILED
    assert run.motion.synthetic  # so it needs no other file


def test_the_command_lines_example_is_the_bookcase_of_the_examples():
    from stayput.cli.flags import EXAMPLE

    built_in, file = sp.Scenario.parse(EXAMPLE).case(), sp.read_scenario(EXAMPLES / "bookcase.toml").case()
    assert (built_in.body, built_in.room) == (file.body, file.room)
