"""Running a tape on arrays, instruction by instruction, into buffers that are used again.

A chunk of all registers that are alive at once fits in the processor's cache: main memory is read
only for the inputs and written only for the outputs.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from operator import itemgetter
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
    steps : (kernel, how to get its arguments, register of its result); where the kernel is None,
        an input is called instead
    pending : a None for every register that is computed
    buffers : the shapes of all buffers
    copied : (output, register) where a value is wanted that is computed somewhere else

    Notes
    -----
    Arguments are found by their places in one list: all registers, then the outputs, then the
    buffers. An array is written to an output where it can be, and to a buffer otherwise.
    """

    def __init__(self, tape: Tape, shapes: Sequence[Shape], fetched: Iterable[int] = ()) -> None:
        self.common = _common(set(shapes))
        self.constants = [p[0] / p[1] if isinstance(p, tuple) else float(p) for p in tape.constants]
        self.steps: list[tuple[Any, Callable[[list[Any]], Sequence[Any]], int]] = []
        self.buffers: list[Shape] = []
        self.pending = [None] * len(tape.instructions)
        outputs = [r for output in tape.outputs.values() for r in output.registers]
        direct = self._assign(tape, outputs, [*shapes, *(() for _ in self.constants)], set(fetched))
        self.copied = [(k, r) for k, r in enumerate(outputs) if direct.get(r) != k]

    def _assign(
        self, tape: Tape, outputs: list[int], shape: list[Shape], waiting: set[int]
    ) -> dict[int, int]:
        """Append all steps, and return which registers are computed as which output."""
        first = len(shape)
        first_output = first + len(tape.instructions)
        first_buffer = first_output + len(outputs)
        last_use = {r: i for i, (_, *operands) in enumerate(tape.instructions) for r in operands}
        last_use |= dict.fromkeys(outputs, len(tape.instructions))  # read at the end
        wanted = {r: k for k, r in reversed(list(enumerate(outputs)))}
        free: dict[Shape, list[int]] = {}
        held: dict[int, int] = {}
        direct: dict[int, int] = {}

        def buffer(register: int) -> int:
            pool = free.get(shape[register])
            if not pool:
                self.buffers.append(shape[register])
            held[register] = pool.pop() if pool else first_buffer + len(self.buffers) - 1
            return held[register]

        def fetch(registers: set[int]) -> None:
            for r in sorted(registers):
                waiting.remove(r)
                self.steps.append((None, _getter([buffer(r)]), r))

        for i, (operation, *operands) in enumerate(tape.instructions):
            fetch(waiting.intersection(operands))
            own, register = _common({shape[r] for r in operands}), first + i
            shape.append(own)
            for r in {r for r in operands if last_use[r] == i and r in held}:
                free.setdefault(shape[r], []).append(held.pop(r))
            places = list(operands)
            if register in wanted and own == self.common != ():
                direct[register] = wanted[register]
                places.append(first_output + wanted[register])
            elif own != ():
                places.append(buffer(register))
            self.steps.append((KERNELS[operation], _getter(places), register))
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
        places = [*inputs, *plan.constants, *plan.pending, *out, *self.buffers]
        for kernel, arguments, register in plan.steps:
            places[register] = (kernel or places[register])(*arguments(places))
        for k, r in plan.copied:
            out[k] = places[r]


def _getter(places: list[int]) -> Callable[[list[Any]], Sequence[Any]]:
    if len(places) == 1:  # of one, itemgetter returns no sequence
        return lambda values: [values[places[0]]]
    return itemgetter(*places)


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
