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


class Plan:
    """What a tape does with inputs of given shapes, and which buffers it takes turns in.

    Parameters
    ----------
    fetched : inputs that are given as functions; each is called with a buffer to fill where its
        values are first needed, so that few of them wait in the cache for their turn

    Attributes
    ----------
    common : the shape that those of the inputs broadcast to
    steps : (kernel or None to fetch, operands, register, output or buffer it is written to)
    buffers : the shapes of all buffers
    copied : (output, register) where a value is wanted that is computed somewhere else
    """

    def __init__(self, tape: Tape, shapes: Sequence[Shape], fetched: Iterable[int] = ()) -> None:
        self.common = _common(set(shapes))
        self.constants = [p[0] / p[1] if isinstance(p, tuple) else float(p) for p in tape.constants]
        self.steps: list[tuple[Any, tuple[int, ...], int, tuple[bool, int] | None]] = []
        self.buffers: list[Shape] = []
        outputs = [r for output in tape.outputs.values() for r in output.registers]
        direct = self._assign(tape, outputs, [*shapes, *(() for _ in self.constants)], set(fetched))
        self.copied = [(k, r) for k, r in enumerate(outputs) if direct.get(r) != k]

    def _assign(
        self, tape: Tape, outputs: list[int], shape: list[Shape], waiting: set[int]
    ) -> dict[int, int]:
        """Append all steps, and return which registers are computed as which output."""
        last_use = {r: i for i, (_, *operands) in enumerate(tape.instructions) for r in operands}
        last_use |= dict.fromkeys(outputs, len(tape.instructions))  # read at the end
        wanted = {r: k for k, r in reversed(list(enumerate(outputs)))}
        free: dict[Shape, list[int]] = {}
        held: dict[int, int] = {}
        direct: dict[int, int] = {}

        def buffer(register: int) -> tuple[bool, int]:
            pool = free.get(shape[register])
            if not pool:
                self.buffers.append(shape[register])
            held[register] = pool.pop() if pool else len(self.buffers) - 1
            return False, held[register]

        def fetch(registers: set[int]) -> None:
            for r in sorted(registers):
                waiting.remove(r)
                self.steps.append((None, (), r, buffer(r)))

        for i, (operation, *operands) in enumerate(tape.instructions):
            fetch(waiting.intersection(operands))
            own, register = _common({shape[r] for r in operands}), len(shape)
            shape.append(own)
            for r in {r for r in operands if last_use[r] == i and r in held}:
                free.setdefault(shape[r], []).append(held.pop(r))
            target: tuple[bool, int] | None = None
            if register in wanted and own == self.common != ():
                direct[register] = wanted[register]
                target = True, wanted[register]
            elif own != ():
                target = buffer(register)
            self.steps.append((KERNELS[operation], tuple(operands), register, target))
        fetch(waiting.intersection(outputs))
        return direct


class Runner:
    """A plan with its buffers; it serves one caller, chunk after chunk.

    With a size, every array of the plan is one of this many entries.
    """

    def __init__(self, plan: Plan, size: int | None = None) -> None:
        self.plan = plan
        self.buffers = [np.empty(shape if size is None else size) for shape in plan.buffers]

    def run(self, inputs: Sequence[Any], out: np.ndarray) -> None:
        """Run on inputs of the shapes planned; row k of `out` becomes output entry k."""
        plan = self.plan
        registers: list[Any] = [*inputs, *plan.constants, *(None for _ in plan.steps)]
        for kernel, operands, register, target in plan.steps:
            arguments = [registers[r] for r in operands]
            if target is not None:
                is_output, k = target
                arguments.append(out[k] if is_output else self.buffers[k])
            registers[register] = (kernel or registers[register])(*arguments)
        for k, r in plan.copied:
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
            runners[shapes] = Runner(Plan(tape, shapes))
        runners[shapes].run(inputs, rows)

    with np.errstate(all="ignore"):
        run(arrays, out)


def _part(array: np.ndarray, part: slice, axis: int) -> np.ndarray:
    """Cut an array along an axis counted from the end, unless it is broadcast along it."""
    if array.ndim < -axis or array.shape[axis] == 1:
        return array
    return array[(..., part) + (slice(None),) * (-1 - axis)]
