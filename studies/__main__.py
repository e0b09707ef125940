"""``python -m studies``: the paper's sections, or those named, with the published numbers beside."""

from __future__ import annotations

import argparse
from pathlib import Path

import stayput as sp
from studies import EVIDENCE, PAPER


def main() -> None:
    """Run studies, print each summary and write data, tables and figures."""
    known = {study.__name__: study for study in (*PAPER, *EVIDENCE)}
    of_a_record = ("wall_gap_record", "tokyo", "contents")
    parser = argparse.ArgumentParser(prog="python -m studies", description=__doc__)
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"{', '.join(known)}; default: the paper's")
    parser.add_argument("--out", type=Path, default=Path("out/paper"), help="folder (default: %(default)s)")
    parser.add_argument("--record", type=Path, help=f"motion of {', '.join(of_a_record)}")
    arguments = parser.parse_args()
    if unknown := sorted(set(arguments.names) - set(known)):
        parser.error(f"there is no study {', '.join(unknown)}; there are {', '.join(known)}")
    motion = None if arguments.record is None else sp.read_motion(arguments.record)
    for name in arguments.names or [study.__name__ for study in PAPER]:
        study = known[name](motion) if motion is not None and name in of_a_record else known[name]()
        files = study.write(arguments.out)
        print(study.markdown(), *(f"Wrote {file}" for file in files), sep="\n", end="\n\n")


if __name__ == "__main__":
    main()
