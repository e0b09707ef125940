"""What standards ask, beside the simulation: one module a standard, with the clause in each docstring.

Only what was read is here; `docs/standards.md` says what was not.
"""
