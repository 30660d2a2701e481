"""Running a tape on arrays, instruction by instruction, into buffers that are used again.

A chunk of all registers that are alive at once fits in the processor's cache: main memory is read
only for the inputs and written only for the outputs.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from .operations import KERNELS

if TYPE_CHECKING:
    from .tape import Tape

# Entries a chunk. 8192 and 32768 are within a fifth of it, from one cubic to 1000 segments.
CHUNK = 16384

Shape = tuple[int, ...]


class Runner:
    """A tape with buffers for inputs of given shapes; it serves one caller, chunk after chunk.

    Parameters
    ----------
    fetched : inputs that `run` is given as functions; each is called with a buffer to fill where
        its values are first needed, so that few of them wait in the cache for their turn

    Attributes
    ----------
    common : the shape that those of the inputs broadcast to
    outputs : the registers of all entries of all outputs, in order
    """

    def __init__(self, tape: Tape, shapes: Sequence[Shape], fetched: Iterable[int] = ()) -> None:
        self.common = _common(set(shapes))
        self.outputs = [r for output in tape.outputs.values() for r in output.registers]
        self._constants = [
            p[0] / p[1] if isinstance(p, tuple) else float(p) for p in tape.constants
        ]
        # (kernel or None to fetch, operands, register, where its values are to be written)
        self._steps: list[tuple[Any, tuple[int, ...], int, int | np.ndarray | None]] = []
        self._row: dict[int, int] = {}  # of the registers that are computed where they are wanted
        self._assign_buffers(tape, [*shapes, *(() for _ in self._constants)], set(fetched))
        self._copied = [(k, r) for k, r in enumerate(self.outputs) if self._row.get(r) != k]

    def _assign_buffers(self, tape: Tape, shape: list[Shape], waiting: set[int]) -> None:
        last_use = {r: i for i, (_, *operands) in enumerate(tape.instructions) for r in operands}
        last_use |= dict.fromkeys(self.outputs, len(tape.instructions))  # read at the end
        wanted = {r: k for k, r in reversed(list(enumerate(self.outputs)))}
        free: dict[Shape, list[np.ndarray]] = {}
        held: dict[int, np.ndarray] = {}

        def buffer(register: int) -> np.ndarray:
            pool = free.get(shape[register])
            held[register] = pool.pop() if pool else np.empty(shape[register])
            return held[register]

        def fetch(registers: set[int]) -> None:
            for r in sorted(registers):
                waiting.remove(r)
                self._steps.append((None, (), r, buffer(r)))

        for i, (operation, *operands) in enumerate(tape.instructions):
            fetch(waiting.intersection(operands))
            own, register = _common({shape[r] for r in operands}), len(shape)
            shape.append(own)
            for r in {r for r in operands if last_use[r] == i and r in held}:
                free.setdefault(shape[r], []).append(held.pop(r))
            target: int | np.ndarray | None = None
            if register in wanted and own == self.common != ():
                target = self._row[register] = wanted[register]
            elif own != ():
                target = buffer(register)
            self._steps.append((KERNELS[operation], tuple(operands), register, target))
        fetch(waiting.intersection(self.outputs))

    def run(self, inputs: Sequence[Any], out: np.ndarray) -> None:
        """Run on inputs of the shapes given; row k of `out` becomes output entry k."""
        registers: list[Any] = [*inputs, *self._constants]
        registers += [None] * len(self._steps)
        for kernel, operands, register, target in self._steps:
            if kernel is None:
                registers[register] = registers[register](target)
                continue
            arguments = [registers[r] for r in operands]
            if target is not None:
                arguments.append(out[target] if isinstance(target, int) else target)
            registers[register] = kernel(*arguments)
        for k, r in self._copied:
            out[k] = registers[r]


def _common(shapes: set[Shape]) -> Shape:
    arrays = shapes - {()}
    return arrays.pop() if len(arrays) == 1 else np.broadcast_shapes(*arrays)


def run_chunked(tape: Tape, arrays: Sequence[np.ndarray], out: np.ndarray) -> None:
    """Run a tape on arrays that broadcast to out.shape[1:], at most `CHUNK` entries at a time."""
    runners: dict[tuple[Shape, ...], Runner] = {}

    def run(inputs: Sequence[np.ndarray], rows: np.ndarray) -> None:
        shape = rows.shape[1:]
        size = int(np.prod(shape))
        if size > CHUNK:
            axis = int(np.argmax(shape))
            step = max(1, CHUNK * shape[axis] // size)
            for start in range(0, shape[axis], step):
                part = slice(start, start + step)
                run([_part(array, part, axis - len(shape)) for array in inputs],
                    rows[(slice(None),) * (axis + 1) + (part,)])  # fmt: skip
            return
        shapes = tuple(array.shape for array in inputs)
        if shapes not in runners:
            runners[shapes] = Runner(tape, shapes)
        runners[shapes].run(inputs, rows)

    with np.errstate(all="ignore"):
        run(arrays, out)


def _part(array: np.ndarray, part: slice, axis: int) -> np.ndarray:
    """Cut an array along an axis counted from the end, unless it is broadcast along it."""
    if array.ndim < -axis or array.shape[axis] == 1:
        return array
    return array[(..., part) + (slice(None),) * (-1 - axis)]
