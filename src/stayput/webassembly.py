"""The mechanics and the floors of buildings as a WebAssembly module.

``python -m stayput.webassembly kernel.wasm`` writes it.

It is made of the same intermediate code as the machine code of this computer, imports nothing, and gives the
same bits: what it calls of elementary functions is `stayput.mechanics.elementary`. The module exports its
memory, ``__heap_base``, from where on the memory is the caller's, and the functions of `FUNCTIONS`, whose
arguments are those that `stayput.compiled.Entry.intermediate_code` tells: pointers are i32, sizes and whole
numbers i64, all else f64.
"""

from __future__ import annotations

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import llvmlite.binding
import numpy as np

from stayput.building import superposition
from stayput.compiled import Entry, kind_of
from stayput.mechanics import engine, flat
from stayput.mechanics.columns import CASE
from stayput.mechanics.devices.columns import ELEMENT
from stayput.mechanics.devices.runner import devices_of
from stayput.mechanics.runner import arguments, shaking

if TYPE_CHECKING:
    from collections.abc import Iterator

llvm: Any = llvmlite.binding  # it has no types

FUNCTIONS = {
    "block_extremes": "`stayput.mechanics.flat.block_extremes`",
    "run_bare": "`stayput.mechanics.engine.run_batch` of bodies without devices",
    "run_held": "the same of bodies with devices",
    "fill_step": "`stayput.building.superposition.fill_step`: one step of a building's modes",
    "linear_histories": "`stayput.building.superposition.linear_histories`: the floors of a linear building",
    "yielding_histories": "`stayput.building.superposition.yielding_histories`: of one whose storeys yield",
}
"""What the module exports, and what each is."""

_LAYOUT = "e-m:e-p:32:32-p10:8:8-p20:8:8-i64:64-i128:128-n32:64-S128-ni:1:10:20"
_TRIPLE = "wasm32-unknown-unknown"
_STACK = 1 << 20  # bytes; a call needs some kilobytes


# The product of two whole numbers of 128 bits: optimized loops can need it, and WebAssembly lacks it; it is
# part of compilers' libraries. Optimized itself, it would be recognized as such a product, and call itself.
_MULTIPLY = """
define void @__multi3(ptr %result, i64 %al, i64 %ah, i64 %bl, i64 %bh) noinline optnone {
  %a0 = and i64 %al, 4294967295
  %a1 = lshr i64 %al, 32
  %b0 = and i64 %bl, 4294967295
  %b1 = lshr i64 %bl, 32
  %p00 = mul i64 %a0, %b0
  %p01 = mul i64 %a0, %b1
  %p10 = mul i64 %a1, %b0
  %p11 = mul i64 %a1, %b1
  %h00 = lshr i64 %p00, 32
  %l01 = and i64 %p01, 4294967295
  %l10 = and i64 %p10, 4294967295
  %m1 = add i64 %h00, %l01
  %mid = add i64 %m1, %l10
  %low = mul i64 %al, %bl
  %h01 = lshr i64 %p01, 32
  %h10 = lshr i64 %p10, 32
  %carry = lshr i64 %mid, 32
  %c1 = mul i64 %al, %bh
  %c2 = mul i64 %ah, %bl
  %s1 = add i64 %p11, %h01
  %s2 = add i64 %s1, %h10
  %s3 = add i64 %s2, %carry
  %s4 = add i64 %s3, %c1
  %high = add i64 %s4, %c2
  store i64 %low, ptr %result
  %second = getelementptr i8, ptr %result, i32 8
  store i64 %high, ptr %second
  ret void
}
"""


def find_linker() -> str | None:
    """Return LLVM's linker for WebAssembly, if it is installed: ``wasm-ld``, or with its version's number."""
    names = ("wasm-ld", *(f"wasm-ld-{number}" for number in range(40, 13, -1)))
    return next(filter(None, map(shutil.which, names)), None)


def build(target: Path) -> None:
    """Compile and link the module.

    Parameters
    ----------
    target : Path
        The file to write.

    Raises
    ------
    RuntimeError
        The linker is not installed, or refuses the code.
    """
    linker = find_linker()
    if linker is None:
        raise RuntimeError("wasm-ld is not installed; it is LLVM's linker for WebAssembly (Debian: lld).")
    llvm.initialize_all_targets()
    llvm.initialize_all_asmprinters()
    machine = llvm.Target.from_triple(_TRIPLE).create_target_machine(
        opt=3, reloc="static", features="+bulk-memory,+sign-ext,+nontrapping-fptoint,+mutable-globals"
    )
    whole = llvm.parse_assembly(f'target datalayout = "{_LAYOUT}"\ntarget triple = "{_TRIPLE}"\n{_MULTIPLY}')
    for name, code in _modules():
        whole.link_in(_retargeted(name, code))
    builder = llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options(speed_level=3))
    builder.getModulePassManager().run(whole, builder)
    exports = [f"--export={name}" for name in (*FUNCTIONS, "__heap_base")]
    with tempfile.TemporaryDirectory() as folder:
        compiled, linked = Path(folder, "kernel.o"), Path(folder, "kernel.wasm")
        compiled.write_bytes(machine.emit_object(whole))
        options = ["--no-entry", "--gc-sections", "--strip-all", "-z", f"stack-size={_STACK}", *exports]
        done = subprocess.run(
            [linker, *options, "-o", str(linked), str(compiled)], capture_output=True, text=True, check=False
        )
        if done.returncode:
            raise RuntimeError(f"{linker} refuses the code: {done.stderr.strip()}")
        shutil.copyfile(linked, target)


def _modules() -> Iterator[tuple[str, bytes]]:
    """Yield the name and the intermediate code of each exported function."""
    values = np.zeros(2)
    yield "block_extremes", _code(flat.block_extremes, (values, values, values))
    cases, motion = np.zeros(1, CASE), shaking(values, None, 0.01, 0)
    held = devices_of(np.zeros((1, 1), ELEMENT), motion)
    yield "run_bare", _code(engine.run_batch, arguments(cases, None, motion))
    yield "run_held", _code(engine.run_batch, arguments(cases, held, motion))
    table = np.zeros((2, 2))
    yield "fill_step", _code(superposition.fill_step, (values, values, 0.01, table))
    tables = (table,) * 6
    yield "linear_histories", _code(superposition.linear_histories, (values, table, values, *tables[:5]))
    yielding = (values, 1, 0.01, table, values, *tables, table, table)
    yield "yielding_histories", _code(superposition.yielding_histories, yielding)


def _code(entry: Any, example: tuple[object, ...]) -> bytes:
    return cast("Entry", entry).intermediate_code(tuple(map(kind_of, example)))


def _retargeted(name: str, code: bytes) -> Any:
    """Return a module for WebAssembly whose one external function has this name."""
    module = llvm.parse_bitcode(code)
    module.data_layout, module.triple = _LAYOUT, _TRIPLE
    for function in module.functions:
        if function.is_declaration:
            continue
        if function.linkage == llvm.Linkage.external:
            function.name = name
        else:
            function.linkage = llvm.Linkage.internal
    for variable in module.global_variables:
        if variable.linkage == llvm.Linkage.common:  # there are none in WebAssembly
            variable.linkage = llvm.Linkage.internal
    return module


if __name__ == "__main__":
    build(Path(sys.argv[1]))
    print(f"{sys.argv[1]}: {Path(sys.argv[1]).stat().st_size} bytes")
