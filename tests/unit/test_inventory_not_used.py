"""What a scenario states and an inventory has no use for is said."""

from pathlib import Path

import pytest

import stayput as sp
from stayput.inventory.scenarios import read_scenario_file

PLAIN = "[shaking]\nintensity = 5.5\n[uncertainty]\nsamples = 40\n"


@pytest.mark.parametrize(
    ("added", "key"),
    [('installation = "as people install it"\n', "installation"), ("[everyday]\nload = 20.0\n", "everyday")],
)
def test_what_only_a_verification_uses_is_said(tmp_path: Path, added: str, key: str) -> None:
    file = tmp_path / "quake.toml"
    file.write_text(PLAIN + added, encoding="utf-8")
    with pytest.warns(sp.InputWarning, match=rf"quake.toml.*{key}.* is not used"):
        read_scenario_file(file)
