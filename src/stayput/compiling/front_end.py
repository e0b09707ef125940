"""Numba as a front end alone: from functions' sources to one module of LLVM's intermediate code.

By default Numba optimizes each function with all that it calls, and makes machine code of it, before it goes
on to the function's callers; that was half of a cold start. Here each function is typed and lowered, and no
more: `stayput.compiling.machine_code` optimizes the module of all of them, once.

What it uses of Numba is public, as the class of a pipeline and that of a code library, except for what a
comment names.
"""

# Numba's methods have types where they can be inferred, and those are not meant.
# pyright: reportIncompatibleMethodOverride=false, reportUnknownVariableType=false
# pyright: reportUnknownArgumentType=false, reportAttributeAccessIssue=false

from __future__ import annotations

import gc
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

import llvmlite.binding
import numba
from numba import _dynfunc as functions_in_c
from numba.core import config, event, typed_passes, untyped_passes
from numba.core.codegen import CodeLibrary
from numba.core.compiler import CompilerBase
from numba.core.compiler_machinery import LoweringPass, PassManager, register_pass

from stayput.compiling.machine_code import uninterrupted
from stayput.errors import InputError

# these have no types, or too few
llvm: Any = llvmlite.binding
njit: Any = numba.njit
numba_types: Any = numba.types

SETTINGS = {"error_model": "numpy", "_nrt": False, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}
"""Division by zero gives infinity or NaN, as in IEEE arithmetic, not an exception; no reference counting. No
Python wrappers, which nothing calls.
"""


class LinkableCode(CodeLibrary):
    """The intermediate code of a function, and the libraries of the functions that it calls."""

    def __init__(self, codegen: Any, name: str) -> None:
        super().__init__(codegen, name)
        self._own = self._symbol = ""
        self._called: list[Any] = []

    def add_ir_module(self, ir_module: Any) -> None:
        """Set the function's own code, beside which there may be small functions of Numba's, not external."""
        for function in ir_module.functions:
            if not function.is_declaration and function.linkage in ("", "external"):
                function.linkage = "linkonce_odr"  # other modules may have the same
                self._symbol = function.name
        self._own = str(ir_module)

    def add_linking_library(self, library: Any) -> None:
        """Add the library of a function that it calls."""
        self._called.append(library)

    def finalize(self) -> None:
        """Do nothing: only the module of all functions is optimized."""

    def get_llvm_str(self) -> str:
        """Return the function's own code."""
        return self._own

    def get_asm_str(self) -> str:
        """There is no machine code."""
        raise NotImplementedError

    def get_function(self, name: str) -> Any:
        """There is no module of this function alone."""
        raise NotImplementedError

    def linked(self) -> Any:
        """Return a module of the function and all that it calls; only it can be called from elsewhere."""
        whole = llvm.parse_assembly(self._own)
        whole.get_function(self._symbol).linkage = llvm.Linkage.external
        for module in self._called_modules({self}):
            whole.link_in(module)
        return whole

    def _get_module_for_linking(self) -> Any:
        """Return the same for a function that Numba compiles in its own way, as tests do (not public)."""
        module = self.linked()
        _share(module)
        return module

    def _called_modules(self, seen: set[Any]) -> Generator[Any]:
        """Yield the code of what is called, callers first: LLVM links only what is called so far."""
        for library in self._called:
            if library in seen:
                continue
            seen.add(library)
            module = llvm.parse_assembly(library.get_llvm_str())
            if isinstance(library, LinkableCode):
                yield module
                yield from library._called_modules(seen)
            else:  # Numba's own, as that of `min`, with all that it calls
                _share(module)
                yield module


def _share(module: Any) -> None:
    """Let other modules have the same external functions; they are left out where nothing calls them."""
    for function in module.functions:
        if not function.is_declaration and function.linkage == llvm.Linkage.external:
            function.linkage = llvm.Linkage.linkonce_odr


@register_pass(mutates_CFG=False, analysis_only=False)
class Registration(LoweringPass):
    """Make a lowered function known to the functions that call it."""

    _name = "stayput_registration"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state: Any) -> bool:
        """Register it under a built-in function, as Numba does it, here one that has no machine code."""
        description = state.cr.fndesc
        key: Any = functions_in_c.make_function(description.lookup_module(), "", "", 0, state.cr.env, ())
        state.targetctx.insert_user_function(key, description, [state.library])
        state.cr = state.cr._replace(cfunc=key)
        return True


class Pipeline(PassManager):
    """The passes that the mechanics need, without the events, timers and checks around each."""

    def __init__(self) -> None:
        super().__init__("stayput")
        for step in (
            untyped_passes.TranslateByteCode,
            untyped_passes.FixupArgs,
            untyped_passes.IRProcessing,
            untyped_passes.RewriteSemanticConstants,  # with the next one: what `held is None` rules out
            untyped_passes.DeadBranchPrune,
            untyped_passes.GenericRewrites,
            untyped_passes.ReconstructSSA,
            typed_passes.NopythonTypeInference,
            typed_passes.PreLowerStripPhis,
            typed_passes.IRLegalization,
            typed_passes.NativeLowering,
            Registration,
            typed_passes.NoPythonBackend,
        ):
            self.add_pass(step)
        self.finalize()
        analysis = self.dependency_analysis()
        self._steps: list[Any] = [step() for step, _ in self.passes]
        for step in self._steps:
            step.analysis = analysis

    def run(self, state: Any) -> None:
        """Run all passes on a function."""
        for step in self._steps:
            step.run_pass(state)


class FrontEnd(CompilerBase):
    """Numba's compiler of a function, up to its intermediate code."""

    def define_pipelines(self) -> list[PassManager]:
        """Return the passes."""
        state: Any = self.state
        state.library = LinkableCode(state.targetctx.codegen(), state.func_id.func_qualname)
        state.flags.no_compile = True
        return [_PIPELINE]


_PIPELINE = Pipeline()


class _Begun(event.Listener):
    """What is told of each function of which Numba begins the compilation."""

    def __init__(self, tell: Callable[[Callable[..., Any]], None]) -> None:
        self._tell = tell

    def on_start(self, event: Any) -> None:
        """Tell the function."""
        self._tell(event.data["dispatcher"].py_func)

    def on_end(self, event: Any) -> None:
        """Tell nothing."""


def dispatcher(function: Callable[..., Any], *, forceinline: bool = False) -> Any:
    """Return a function as Numba compiles it: once for each argument type.

    By default Numba specializes a function for each literal (as ``True`` or ``0.0``) that it is called with,
    which multiplies the time of a cold start.

    Raises
    ------
    InputError
        Numba is told not to compile.
    """
    if config.DISABLE_JIT:
        raise InputError("common.compilation_disabled", "NUMBA_DISABLE_JIT")
    compiled = njit(**SETTINGS, forceinline=forceinline, pipeline_class=FrontEnd)(function)
    template = compiled.get_call_template

    def template_of(args: Any, kws: Any) -> Any:
        return template(tuple(map(numba_types.unliteral, args)), kws)

    compiled.get_call_template = template_of
    return compiled


def bitcode(
    function: Callable[..., Any], kinds: tuple[Any, ...], tell: Callable[[Callable[..., Any]], None]
) -> bytes:
    """Compile a function with all that it calls.

    Parameters
    ----------
    function : callable
        Its source.
    kinds : tuple
        Numba's types of its arguments.
    tell : callable
        Is called with each function of which the compilation begins.

    Returns
    -------
    bytes
        LLVM's intermediate code, not optimized: a module whose one external function is this one.
    """
    compiled = dispatcher(function)
    with (
        _without_garbage_collection(),
        _resolved_once(compiled.typingctx),
        event.install_listener("numba:compile", _Begun(tell)),
    ):
        compiled.compile(kinds)
    (result,) = compiled.overloads.values()
    return uninterrupted(lambda: result.library.linked().as_bitcode())


@contextmanager
def _without_garbage_collection() -> Generator[None]:
    """Leave garbage be: there is little among millions of objects, and looking takes a tenth of the time."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@contextmanager
def _resolved_once(context: Any) -> Generator[None]:
    """Remember what each function called with arguments of some types returns.

    Numba types a function in rounds, until nothing changes; in each round it would try all that an operator
    may mean once more, NumPy's meanings among them.
    """
    resolve: Callable[..., Any] = context.resolve_function_type
    known: dict[Any, Any] = {}

    def remembered(function: Any, args: Any, kws: Any) -> Any:
        if kws or not isinstance(function, numba_types.Type):  # arguments that may not be types
            return resolve(function, args, kws)
        key = function, tuple(args)
        signature = known.get(key)
        if signature is None:
            signature = resolve(function, args, kws)
            if signature is not None:
                known[key] = signature
        return signature

    context.resolve_function_type = remembered
    try:
        yield
    finally:
        del context.resolve_function_type
