"""Numba as a front end: from a function's source to one module of LLVM's intermediate code, not optimized.

By default Numba optimizes each function with all that it calls, and makes machine code of it, before it goes
on to the function's callers. Here only the module as a whole is optimized, once and elsewhere.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import llvmlite.binding
from numba import _dynfunc
from numba.core import typed_passes, untyped_passes
from numba.core.codegen import CodeLibrary
from numba.core.compiler import CompilerBase
from numba.core.compiler_machinery import LoweringPass, PassManager, register_pass

if TYPE_CHECKING:
    from collections.abc import Generator

llvm: Any = llvmlite.binding  # it has no types


class IntermediateCode(CodeLibrary):
    """The intermediate code of a function, and where that of the functions is that it calls."""

    def __init__(self, codegen: Any, name: str) -> None:
        super().__init__(codegen, name)
        self._texts: list[str] = []
        self._called: list[CodeLibrary] = []

    def add_ir_module(self, ir_module: Any) -> None:
        self._texts.append(str(ir_module))

    def add_linking_library(self, library: CodeLibrary) -> None:
        self._called.append(library)

    def finalize(self) -> None:
        self._finalized = True

    def get_function(self, name: str) -> Any:
        raise NotImplementedError

    def get_pointer_to_function(self, name: str) -> int:
        """There is no machine code."""
        return 0

    def get_llvm_str(self) -> str:
        return "\n".join(self._texts)

    def get_asm_str(self) -> str:
        raise NotImplementedError

    def linked(self, symbol):
        whole = llvm.parse_assembly("")
        for text in self._all_texts(set()):
            module = llvm.parse_assembly(text)
            for function in module.functions:
                if not function.is_declaration and function.name != symbol:
                    function.linkage = llvm.Linkage.linkonce_odr
            whole.link_in(module)
        return str(whole)

    def _all_texts(self, seen):
        seen.add(self)
        yield from self._texts
        for library in self._called:
            if library not in seen:
                if isinstance(library, IntermediateCode):
                    yield from library._all_texts(seen)
                else:
                    seen.add(library)
                    yield library.get_llvm_str()


@register_pass(mutates_CFG=False, analysis_only=False)
class Registration(LoweringPass):
    """Make the function known to those that call it."""

    _name = "stayput_registration"

    def __init__(self) -> None:
        super().__init__()

    def run_pass(self, state):
        lowered = state.cr
        key = _dynfunc.make_function(lowered.fndesc.lookup_module(), lowered.fndesc.qualname, "", 0, lowered.env, ())
        state.targetctx.insert_user_function(key, lowered.fndesc, [state.library])
        state.cr = lowered._replace(cfunc=key)
        return True


class FrontEnd(CompilerBase):
    def define_pipelines(self):
        state = self.state
        state.flags.no_compile = True
        state.library = IntermediateCode(state.targetctx.codegen(), state.func_id.func_qualname)
        manager = PassManager("stayput")
        for step in (
            untyped_passes.TranslateByteCode,
            untyped_passes.FixupArgs,
            untyped_passes.IRProcessing,
            untyped_passes.RewriteSemanticConstants,
            untyped_passes.DeadBranchPrune,
            untyped_passes.GenericRewrites,
            untyped_passes.ReconstructSSA,
            typed_passes.NopythonTypeInference,
            typed_passes.PreLowerStripPhis,
            typed_passes.NopythonRewrites,
            typed_passes.IRLegalization,
            typed_passes.NativeLowering,
            Registration,
            typed_passes.NoPythonBackend,
        ):
            manager.add_pass(step)
        manager.finalize()
        return [manager]
