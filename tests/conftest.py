"""Interrupts reach the programs that tests start, even where the tests run in the background of a shell."""

import signal

# a shell has what it starts in the background ignore interrupts, and so does all that is started from there
if signal.getsignal(signal.SIGINT) == signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
