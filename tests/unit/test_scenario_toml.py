"""TOML that a parser would take much time, memory or depth for: refused with one sentence."""

import tracemalloc

import pytest

from stayput.errors import InputError
from stayput.scenario import read
from stayput.scenario.toml import read_toml

WELL = '[furniture]\npreset = "bookcase"\n'


@pytest.fixture
def refusal(tmp_path):
    """Read a text as a scenario; return the sentence that refuses it."""

    def refuse(text):
        file = tmp_path / "scenario.toml"
        file.write_text(text)
        with pytest.raises(InputError) as error:
            read(file)
        said = str(error.value)
        assert said.startswith("scenario.toml: ")
        assert said.endswith(".")
        assert len(said) <= 600
        return said

    return refuse


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("a = " + "[" * 5000 + "]" * 5000, "nest at most 16 deep"),
        ("a = " + "{a=" * 5000 + "1" + "}" * 5000, "nest at most 16 deep"),
        ("a = " + "[" * 200_000, "nest at most 16 deep"),
        ("a = " + "9" * 5000, "exceeds 64 bits"),
        ("[furniture]\nwidth = 0x" + "f" * 20_000, "exceeds 64 bits"),
        (f"a = {2**63}", "exceeds 64 bits"),
        (".".join("a" * 20_000) + " = 1", "have 19998 parts beyond two each; they must have at most 300"),
        (" . ".join(['"a.b"'] * 303) + " = 1", "have 301 parts beyond two each"),
        ("[" + ".".join("a" * 20_000) + "]", "have 19998 parts beyond two each; they must have at most 300"),
        ("\n".join(f"a{i}.b.c.d = 1" for i in range(600)), "have 1200 parts beyond two each"),
        ("# " + "x" * (1 << 20), "it may have 1048576 bytes at most"),
        (WELL + "a" * 40_000 + " = 1", "aaa… is unknown"),
        (WELL + "[" + "a" * 40_000 + "]", "aaa… is unknown"),
        ("title = '" + "x" * 40_000 + "'\n" + WELL, "xxx…; it must be a text of 1 to 200 characters"),
        (f"title = '{'x' * 40_000}", "it must be TOML, but: "),
        ("a = 1\n" + "a" * 40_000 + " = 1\n" + "a" * 40_000 + " = 1", "it must be TOML, but: "),
        ('a = """' + '\\"""' * 5000, "it must be TOML, but: "),
        ("a = '" * 5000, "it must be TOML, but: "),
    ],
)
def test_a_file_that_is_refused(refusal, text, message):
    assert message in refusal(text)


def test_the_longest_key_that_is_read_is_refused_as_any_that_is_not_known(refusal):
    assert "a is unknown" in refusal(WELL.replace("[furniture]", ".".join("a" * 302) + " = 1\n[furniture]"))


def test_a_dotted_key_of_40_kb_takes_little_memory(refusal):
    text = ".".join("a" * 20_000) + " = 1"
    refusal(text)
    tracemalloc.start()
    refusal(text)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 8e6


def test_dots_and_brackets_in_strings_and_comments_do_not_count(tmp_path):
    file = tmp_path / "scenario.toml"
    deep = "[" * 40 + "." * 40
    file.write_text(
        f'# {deep}\ntitle = "{deep} \\" {deep} # no comment"  # {deep}\n'
        f"[furniture]\npreset = 'bookcase'\nname = '{deep}'\n"
        f'[a."{deep}"]\nb = """{deep}\\"""{deep}"""\nc = \'\'\'{deep}\'{deep}\'\'\'\nd = [1.5, [2.5]]\n'
    )
    table = read_toml(file)
    assert table["a"][deep]["b"] == f'{deep}"""{deep}'[: len(deep) + 1] + f'""{deep}'
    assert table["a"][deep]["c"] == f"{deep}'{deep}"
    assert table["furniture"]["name"] == deep
