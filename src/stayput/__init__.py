"""stayput verifies earthquake-proof measures for furniture.

Will it stay put, what happens if it does not, and what helps? Public names are listed once, in the stub
``__init__.pyi``, and load on first use, so that ``import stayput`` stays light.
"""

import lazy_loader

__version__ = "0.1.0"

# Type checkers read the stub and never come here; the library itself is not fully typed.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)  # pyright: ignore
