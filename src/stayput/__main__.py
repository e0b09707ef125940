"""`python -m stayput`: the command line."""

from stayput.cli import main

if __name__ == "__main__":
    main()
