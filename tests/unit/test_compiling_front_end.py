"""Numba as a front end alone: what is in a module, and that nothing of Numba is left changed."""

import gc

import llvmlite.binding as llvm
import numba
import numpy as np
import pytest
from numba import float64, types
from numba.core.compiler import DefaultPassBuilder, Flags
from numba.core.errors import TypingError
from numba.core.registry import cpu_target
from numba.core.untyped_passes import DeadBranchPrune

from stayput.compiling import entry, inner
from stayput.compiling.front_end import Pipeline, bitcode
from stayput.errors import InputError

COLUMN = types.Array(float64, 1, "C", aligned=True)


@inner
def shared(x):
    return min(x, 2.0) + 1.0


@inner
def left(x):
    return 2.0 * shared(x)


@inner
def right(x):
    return 3.0 * shared(x)


@inner
def unused(x):
    return x


def whole(x, device, result):
    result[0] = left(x) + right(x)
    if device is not None:
        result[0] = unused(x)


def module_of(function=whole, kinds=(float64, types.none, COLUMN), tell=lambda function: None):
    return llvm.parse_bitcode(bitcode(function, kinds, tell))


def test_a_module_has_each_function_once_and_the_entry_alone_can_be_called():
    functions = [function for function in module_of().functions if not function.is_declaration]
    assert [f.name.count("whole") for f in functions if f.linkage == llvm.Linkage.external] == [1]
    for name in ("left", "right", "shared"):
        assert sum(f"{len(name)}{name}" in function.name for function in functions) == 1


def test_small_functions_of_numba_beside_a_function_are_not_taken_for_it():
    def divided(x, result):
        result[0] = x // 2

    functions = [f for f in module_of(divided, (float64, COLUMN)).functions if not f.is_declaration]
    assert len(functions) > 1
    assert ["divided" in f.name for f in functions if f.linkage == llvm.Linkage.external] == [True]


def test_nothing_is_optimized_before_the_module_is_whole():
    function = next(f for f in module_of().functions if "4left" in f.name)
    assert "alloca" in str(function)  # variables in memory, which any optimization makes registers


def test_what_an_absent_argument_rules_out_is_not_compiled():
    begun = []
    module_of(tell=begun.append)
    assert whole in begun
    assert unused.py_func not in begun


def test_each_function_is_told_as_its_compilation_begins_and_none_twice():
    @inner
    def part(x):
        return x + 1.0

    def caller(x, result):
        result[0] = part(x) * part(2.0 * x)

    begun = []
    module_of(caller, (float64, COLUMN), begun.append)
    assert begun == [caller, part.py_func]
    begun.clear()
    module_of(caller, (float64, COLUMN), begun.append)  # what is compiled already stays so
    assert begun == [caller]


def test_numba_and_the_garbage_collection_are_left_as_they_were():
    def broken(result):
        result[0] = "text" * 1.5

    assert gc.isenabled()
    for function, kinds in ((whole, (float64, types.none, COLUMN)), (broken, (COLUMN,))):
        try:
            module_of(function, kinds)
        except TypingError:
            assert function is broken
        assert gc.isenabled()
        assert "resolve_function_type" not in vars(cpu_target.typing_context)
    gc.disable()
    try:
        module_of()
        assert not gc.isenabled()
    finally:
        gc.enable()


def test_numbers_of_equal_value_and_other_type_are_told_apart(monkeypatch, tmp_path):
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))

    @inner
    def halved(x):
        return x / 2

    @entry
    def calls(x, count, result):
        result[0], result[1], result[2] = halved(True), halved(1), halved(1.0)
        result[3], result[4] = x // 2, count // 2
        result[5] = (1.5, 2)[1] + (1.5, 2)[0]

    result = np.zeros(6)
    calls(5.5, 5, result)
    assert result.tolist() == [0.5, 0.5, 0.5, 2.0, 2.0, 3.5]


def test_the_passes_are_those_of_numba_in_its_order_but_for_those_that_the_mechanics_do_not_need():
    """A version of Numba with another pass fails here: is it needed?"""
    state = type("State", (), {"func_ir": None, "flags": Flags()})()
    usual = [step for step, _ in DefaultPassBuilder.define_nopython_pipeline(state).passes]
    ours = [step.__name__ for step, _ in Pipeline().passes]
    first = usual.index(DeadBranchPrune)  # it runs three times; the mechanics need the first
    once = [step.__name__ for n, step in enumerate(usual) if step is not DeadBranchPrune or n == first]
    assert [name for name in once if name in ours] == [name for name in ours if name != "Registration"]
    assert set(once) - set(ours) == {
        "WithLifting",
        "InlineClosureLikes",
        "RewriteDynamicRaises",
        "MakeFunctionToJitFunction",
        "InlineInlinables",
        "FindLiterallyCalls",
        "LiteralUnroll",
        "LiteralPropagationSubPipelinePass",
        "InlineOverloads",
        "NopythonRewrites",
        "NoPythonSupportedFeatureValidation",
        "AnnotateTypes",
        "DumpParforDiagnostics",
    }


def test_what_is_used_of_numba_and_not_public_is_there():
    """Where it is not, Numba compiles by itself."""
    assert hasattr(numba.core.codegen.CPUCodeLibrary, "_get_module_for_linking")
    assert hasattr(numba._dynfunc, "make_function")


def test_numba_may_not_be_switched_off(monkeypatch):
    monkeypatch.setattr("numba.core.config.DISABLE_JIT", 1)
    with pytest.raises(InputError, match="NUMBA_DISABLE_JIT"):
        module_of()
