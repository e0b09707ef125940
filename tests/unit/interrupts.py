"""What tests that interrupt a program need."""

import signal


def hears_interrupts() -> None:
    """Undo, in a new process, that a shell has what runs in its background ignore interrupts."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
