"""The command line: heavy modules are loaded only when a command runs."""

import sys

from stayput.cli import interrupts

with interrupts.HandledBy(interrupts.end_at_once):
    from stayput.cli.commands import app

__all__ = ["app", "main"]


def main() -> None:
    """Run the command line: the entry point of ``stayput``."""
    with interrupts.HandledBy(interrupts.raise_after_imports, afterwards=interrupts.end_at_once):
        try:
            app(prog_name="stayput")
        except KeyboardInterrupt:
            sys.exit(interrupts.INTERRUPTED)
