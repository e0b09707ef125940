"""Ways to damage a text, drawn by Hypothesis: each is one that files meet, or that an attacker would try."""

from __future__ import annotations

import re

from hypothesis import strategies as st

NUMBER = re.compile(r"(?<![\w.])[+\-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+\-]?[0-9]+)?")
TOKEN = re.compile(r"[A-Za-z]+|[0-9.]+|[^\sA-Za-z0-9]")
CHARACTERS = "0123456789.,-+eE \t\n\r#;:=()[]{}'\"/\\&|<>_*NSEWUDXGanif\0\x7fé加０٣²"
RUNS = (
    " ",
    "\t",
    "0",
    "1",
    "9",
    "a",
    ".",
    "-",
    ",",
    "=",
    "(",
    "[",
    "{",
    "'",
    '"',
    "\n",
    "NPTS",
    " .",
    "units=",
    "\\",
)
LONGEST_RUN = 9000


def odd_spellings(number: str) -> list[str]:
    """Return other spellings of a number, and what only looks like one."""
    plain = number.lstrip("+-")
    return [
        f"+{plain}",
        f"-{plain}",
        f"{plain}e0",
        f"{plain}E+00",
        f"0000{plain}",
        f"{plain}." if "." not in plain else f"{plain}000",
        f"{plain}d0",
        plain.replace(".", ","),
        f"1,{plain}",
        f"{plain}/1",
        f"{plain} {plain}",
        f"0x{plain}",
        f"{plain[:1]}_{plain[1:]}",
        plain.translate({ord(d): 0xFF10 + int(d) for d in "0123456789"}),
        f"{plain}.{plain}.{plain}",
        "nan",
        "inf",
        "1e999",
        "-0",
        "",
        "9" * 400,
        "*" * len(plain),
    ]


@st.composite
def damaged(draw, text: str, spared: tuple[tuple[int, int], ...] = ()) -> str:
    """Draw a text with one piece of damage.

    Parameters
    ----------
    text : str
        The whole text.
    spared : tuple of (int, int)
        Where each part begins and ends that nothing is done to; a cut may take it away.
    """

    def free(start: int, end: int) -> bool:
        return all(end < low or start > high for low, high in spared)

    places = st.integers(0, len(text) - 1).filter(lambda i: free(i, i + 1))
    kind = draw(st.sampled_from(["change", "insert", "delete", "repeat", "number", "run", "cut", "move"]))
    if kind == "cut":
        return text[: draw(st.integers(0, len(text) - 1))]
    if kind in ("repeat", "number"):
        found = [
            m for m in (TOKEN if kind == "repeat" else NUMBER).finditer(text) if free(m.start(), m.end())
        ]
        one = draw(st.sampled_from(found))
        if kind == "repeat":
            other = (one[0] + draw(st.sampled_from(["", " ", ",", "\n"]))) * draw(st.integers(2, 40))
        else:
            other = draw(st.sampled_from(odd_spellings(one[0])))
        return text[: one.start()] + other + text[one.end() :]
    i = draw(places)
    if kind == "change":
        return text[:i] + draw(st.sampled_from(CHARACTERS)) + text[i + 1 :]
    if kind == "insert":
        return text[:i] + draw(st.sampled_from(CHARACTERS)) + text[i:]
    if kind == "delete":
        return text[:i] + text[i + 1 :]
    if kind == "run":
        part = draw(st.sampled_from(RUNS))
        length = draw(st.sampled_from([2, 10, 100, 1000, LONGEST_RUN]))
        return text[:i] + part * max(1, length // len(part)) + text[i:]
    j = draw(places)
    lines = text.split("\n")
    first, second = (text.count("\n", 0, place) for place in (i, j))
    if all(free(text.find(lines[k]), text.find(lines[k]) + len(lines[k])) for k in (first, second)):
        lines[first], lines[second] = lines[second], lines[first]
    return "\n".join(lines)
