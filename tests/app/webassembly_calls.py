"""Calls into a WebAssembly module: arrays in its memory, and arguments as compiled functions take them."""

from __future__ import annotations

from typing import Any

import numpy as np

PLACE = """
  const bytes = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const { instance } = await WebAssembly.instantiate(bytes(module), {});
  const { memory, __heap_base: base } = instance.exports;
  const image = bytes(content);
  const missing = base.value + image.length - memory.buffer.byteLength;
  if (missing > 0) memory.grow(Math.ceil(missing / 65536));
  new Uint8Array(memory.buffer).set(image, base.value);
  const numbers = given.map(([kind, number]) => (kind === "q" ? BigInt(number) : (number ?? Infinity)));
"""
"""Script of a page: makes ``instance`` of a module, with an image in its memory, and arguments as numbers."""

Flat = list[tuple[str, float | int]]


class Image:
    """Memory of a module from ``base`` on, with the arrays of a call; each keeps its place."""

    def __init__(self, base: int) -> None:
        self.base, self.size = base, 0
        self._arrays: list[tuple[int, np.ndarray]] = []

    def place(self, array: np.ndarray) -> int:
        self.size = -(-self.size // 16) * 16
        place = self.base + self.size
        self._arrays.append((self.size, array))
        self.size += array.nbytes
        return place

    def arguments(self, argument: Any) -> Flat:
        """Return an argument as numbers with their types: p a pointer, q a whole number, d a float."""
        match argument:
            case np.ndarray():
                head = [("p", 0), ("p", 0), ("q", argument.size), ("q", argument.itemsize)]
                sizes = [("q", number) for number in (*argument.shape, *argument.strides)]
                return [*head, ("p", self.place(argument)), *sizes]
            case tuple():
                return [number for part in argument for number in self.arguments(part)]
            case None:
                return [("p", 0)]
            case float():
                return [("d", argument)]
            case _:
                return [("q", int(argument))]

    def call(self, arguments: tuple[Any, ...]) -> Flat:
        """Return all arguments of a call: places for a value and an exception, then the function's own."""
        unused = np.zeros(2)
        return [("p", self.place(unused)), ("p", self.place(unused)), *self.arguments(tuple(arguments))]

    def content(self) -> bytes:
        memory = bytearray(self.size)
        for place, array in self._arrays:
            memory[place : place + array.nbytes] = array.tobytes()
        return bytes(memory)

    def read_back(self, memory: bytes) -> None:
        """Set the arrays to what the module has left in its memory."""
        for place, array in self._arrays:
            part = memory[place : place + array.nbytes]
            array[...] = np.frombuffer(part, array.dtype).reshape(array.shape)
