"""``--help`` of every command in both languages: its sentences, headings, width and columns."""

from __future__ import annotations

import os
import re
import subprocess
import sys

import pytest
from commands import cli
from rich.cells import cell_len
from typer.main import get_command
from typer.testing import CliRunner

from stayput.catalogue import TEXTS, say
from stayput.cli import app
from stayput.cli.help import japanese_help, translate

HEADINGS = ("usage", "arguments", "options", "commands")
TYPERS = ("help", "install_completion", "show_completion")
"""Flags that Typer adds."""

JAPANESE = re.compile(r"[ぁ-んァ-ヶ一-龠]")
WORDS = re.compile(r"[A-Za-z]{2,} [A-Za-z]{2,}")
"""Two words of an English sentence; names, values and units never follow each other so."""


def tree(command=None, before: tuple[str, ...] = ()):
    command = command or get_command(app)
    yield before, command
    for name, one in getattr(command, "commands", {}).items():
        yield from tree(one, (*before, name))


COMMANDS = [pytest.param(words, command, id=" ".join(("stayput", *words))) for words, command in tree()]


def ids_of(command) -> list[str]:
    """Return what a command says, by the ids that stand in the place of the sentences."""
    of_params = [param.help for param in command.params if param.name not in TYPERS]
    defaults = [param.show_default for param in command.params if isinstance(param.show_default, str)]
    return [command.help, *of_params, *defaults]


def told(*words: str, language: str = "ja", flag: bool = True) -> str:
    """Return the help as a terminal of 80 columns shows it."""
    given = ("--lang", language) if flag else ()
    locale = "ja_JP.UTF-8" if language == "ja" and not flag else "C.UTF-8"
    runner = CliRunner(env={"LC_ALL": locale})
    done = runner.invoke(app, [*words, *given, "--help"], prog_name="stayput")
    assert done.exit_code == 0, done.output
    assert "cli_help" not in done.output
    return done.output


def test_each_text_is_there_and_each_is_told() -> None:
    named = {each for _, command in tree() for each in ids_of(command)}
    assert named <= TEXTS.keys()
    assert {key for key in TEXTS if key.startswith("cli_help.")} == named | {
        f"cli_help.{key}" for key in (*HEADINGS, *TYPERS, "required", "default", "range")
    }


@pytest.mark.parametrize(("words", "command"), COMMANDS)
def test_help_is_japanese(words: tuple[str, ...], command) -> None:
    said = told(*words)
    one_line = "".join(said.split())
    for key in ids_of(command):
        text = say(key, "ja")
        assert JAPANESE.search(text), key
        assert not WORDS.search(text), key
        assert "".join(text.split()) in one_line or key == "cli_help.of_locale"
    for param in (*command.params, "help"):
        key = getattr(param, "name", param)
        assert key not in TYPERS or "".join(say(f"cli_help.{key}", "ja").split()) in one_line
    assert not re.search(r"Usage|Options:|Arguments:|Commands:|default|required|Show|<=x|locale", said)
    assert said.startswith(f"使い方：{' '.join(('stayput', *words))} [OPTIONS]")
    assert said == told(*words, flag=False)


@pytest.mark.parametrize(("words", "command"), COMMANDS)
def test_every_command_has_short_flags_for_help_and_quiet(words: tuple[str, ...], command) -> None:
    assert cli(*words, "-h").stdout == cli(*words, "--help").stdout
    assert any("-q" in parameter.opts for parameter in command.params) or words == ("motion",)


@pytest.mark.parametrize("width", [60, 80])
@pytest.mark.parametrize("words", [case.values[0] for case in COMMANDS], ids=" ".join)
def test_japanese_lines_fit_and_begin_with_no_mark(words: tuple[str, ...], width: int) -> None:
    root = get_command(app)
    translate(root, "ja")
    command = dict(tree(root))[words]
    context = command.context_class(command, info_name=" ".join(("stayput", *words)))
    for line in japanese_help(command, context, width).splitlines():
        assert cell_len(line) <= width
        assert line == line.rstrip()
        assert not re.match(r"\s*[、。，：）」・ーっッゃゅょャュョ]", line)


def test_the_terminal_says_the_width() -> None:
    environment = {**os.environ, "LC_ALL": "ja_JP.UTF-8", "COLUMNS": "60", "PYTHONUTF8": "1"}
    start = [sys.executable, "-m", "stayput", "verify", "--help"]
    done = subprocess.run(start, env=environment, capture_output=True, encoding="utf-8", check=True)
    assert 50 < max(map(cell_len, done.stdout.splitlines())) <= 60


IN_JAPANESE = """\
使い方：stayput app [OPTIONS]

  アプリを起動する（揺れと対策の効果を画面で見る）

オプション：
  --host <str>              待ち受けるアドレス。ループバック以外では、ほかのマシ
                            ンからも接続できる  [既定値：127.0.0.1]
  --port <int range>        ポート番号（0なら空いているもの）
                            [既定値：8000、0～65535]
  --name NAME               プロキシ経由で使うときのサーバー名（複数可）
  --browser / --no-browser  ブラウザーでページを開くかどうか
                            [既定値：--browser]
  --lang en|ja              表示、図、レポートの言語  [既定値：ロケールの言語]
  -q, --quiet               結果とエラーだけを表示する
  -h, --help                この説明を表示して終了する
"""


def test_one_command_as_it_is_printed() -> None:
    """In either language in one process, one after the other and back."""
    for _ in range(2):
        assert told("app", language="en").startswith("Usage: stayput app [OPTIONS]")
        assert told("app") == IN_JAPANESE
        assert told("app", flag=False) == IN_JAPANESE


@pytest.mark.parametrize(
    "words",
    [
        ("verify", "--help", "--lang", "ja"),
        ("verify", "--lang=ja", "-h"),
        ("--lang", "ja", "verify", "--help"),
        ("--help", "--lang", "ja"),
        ("motion", "--lang", "ja", "plot", "-h"),
    ],
)
def test_the_language_may_be_said_anywhere(words: tuple[str, ...]) -> None:
    done = cli(*words, LC_ALL="C.UTF-8")
    assert done.exit_code == 0
    assert done.output.startswith("使い方：")


def test_a_language_before_the_command_is_that_of_the_command() -> None:
    for words in (("--lang", "ja", "motion", "info"), ("motion", "--lang", "ja", "info")):
        done = cli(*words, "near-fault", LC_ALL="C.UTF-8")
        assert "計測震度" in done.output
        done = cli(*words, "near-fault", "--lang", "en", LC_ALL="C.UTF-8")
        assert "JMA intensity" in done.output
    done = cli("--lang", "xx", "verify", "none.toml", LC_ALL="C.UTF-8")
    assert (done.exit_code, done.stderr) == (2, "The language is 'xx'; it must be one of 'en', 'ja'.\n")


@pytest.mark.parametrize("words", [(), ("motion",)])
def test_a_group_without_a_command_shows_its_help_in_the_language_of_the_locale(
    words: tuple[str, ...],
) -> None:
    done = cli(*words, LC_ALL="ja_JP.UTF-8")
    assert "コマンド：" in done.output + done.stderr
