"""The tape: a derivation's formulas as a straight-line program that is plain data.

NumPy runs it here, a small interpreter runs the same JSON in the browser. It holds numbers and
names of operations, never code.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from symbolic.errors import BadType, BadValue, shown
from symbolic.exact import as_list, exact

from ..points import real_array
from .compile import Program
from .operations import ARITY
from .runner import run_chunked


@dataclass(frozen=True)
class Output:
    """Where one named output stands: its shape and the registers of its entries, row by row."""

    shape: tuple[int, ...]
    registers: tuple[int, ...]


@dataclass(frozen=True)
class Tape:
    """A straight-line program on registers.

    The first registers are the inputs, then come the constants; every instruction
    (operation, operands...) writes the next one.

    Attributes
    ----------
    inputs : names of the inputs
    constants : numbers, or pairs (p, q) for the exact rational p/q
    instructions : tuples of an operation's name and the registers of its operands
    outputs : mapping of name to Output
    """

    inputs: tuple[str, ...]
    constants: tuple[float | tuple[int, int], ...]
    instructions: tuple[tuple[Any, ...], ...]
    outputs: Mapping[str, Output]

    def run(self, values: Mapping[str, Any] | Sequence[Any]) -> dict[str, np.ndarray]:
        """Run the program on numbers or arrays that broadcast against each other.

        Parameters
        ----------
        values : mapping of input name to value, or the values in the order of `inputs`

        Returns
        -------
        dict
            Every output as a float64 array of shape (broadcast shape of the inputs) + its own.
            Divisions by zero give inf or nan, as NumPy has it. One entry of an output is
            contiguous in memory, for all inputs; no temporary is larger than a chunk of these.

        Raises
        ------
        BadValue
            If values are missing or too many.

        Examples
        --------
        >>> x, y = sp.symbols("x y")
        >>> tape = compile_tape({"p": [x + y, x*y]}, [x, y])
        >>> tape.run({"x": [1, 2], "y": 10})["p"]
        array([[11., 10.],
               [12., 20.]])
        """
        arrays = [real_array(value, "inputs") for value in self._ordered(values)]
        common = np.broadcast_shapes(*(array.shape for array in arrays))
        out = np.empty((sum(len(o.registers) for o in self.outputs.values()), *common))
        run_chunked(self, arrays, out)
        results, first = {}, 0
        for name, output in self.outputs.items():
            rows = out[first : first + len(output.registers)]
            results[name] = np.moveaxis(rows, 0, -1).reshape(common + output.shape)
            first += len(output.registers)
        return results

    def to_json(self) -> dict[str, Any]:
        """Return the tape as JSON data: flat lists of numbers, and names.

        Examples
        --------
        >>> x = sp.Symbol("x")
        >>> compile_tape({"y": x**2 / 3}, [x]).to_json()["operations"]
        ['mul']
        """
        operations = sorted({instruction[0] for instruction in self.instructions})
        code: list[int] = []
        for operation, *operands in self.instructions:
            code += [operations.index(operation), *operands]
        return {
            "inputs": list(self.inputs),
            "constants": [list(c) if isinstance(c, tuple) else c for c in self.constants],
            "operations": operations,
            "code": code,
            "outputs": {
                name: {"shape": list(output.shape), "registers": list(output.registers)}
                for name, output in self.outputs.items()
            },
        }

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Tape:
        """Read what `to_json` wrote; anything else is not checked.

        >>> x = sp.Symbol("x")
        >>> tape = compile_tape({"y": x**2 / 3}, [x])
        >>> Tape.from_json(tape.to_json()) == tape
        True
        """
        code, instructions = list(data["code"]), []
        at = 0
        while at < len(code):
            operation = data["operations"][code[at]]
            end = at + 1 + ARITY[operation]
            instructions.append((operation, *code[at + 1 : end]))
            at = end
        return cls(
            tuple(data["inputs"]),
            tuple(tuple(c) if isinstance(c, list) else c for c in data["constants"]),
            tuple(instructions),
            {
                name: Output(tuple(output["shape"]), tuple(output["registers"]))
                for name, output in data["outputs"].items()
            },
        )

    def _ordered(self, values: Mapping[str, Any] | Sequence[Any]) -> list[Any]:
        if isinstance(values, Mapping):
            by_name = {str(name): value for name, value in values.items()}
            if set(by_name) == set(self.inputs):
                return [by_name[name] for name in self.inputs]
            received = ", ".join(by_name) or "none"
        elif isinstance(values, list | tuple | np.ndarray) and len(values) == len(self.inputs):
            return list(values)
        else:
            received = shown(values)
        raise BadValue(
            f"one value for each of the inputs {', '.join(self.inputs)}",
            received,
            "Give exactly these.",
        )


def compile_tape(outputs: Mapping[str, Any], inputs: Iterable[sp.Symbol]) -> Tape:
    """Compile named SymPy expressions, or nested lists of them, into a tape.

    Expressions are taken as they are, never expanded; what they share is computed once.

    Parameters
    ----------
    outputs : mapping of name to expression, list or matrix of expressions
    inputs : symbols, in the order in which values will be given; matched by name

    Raises
    ------
    BadValue, BadType
        For symbols that are not inputs, functions a tape does not have, ragged lists, text.

    Examples
    --------
    >>> from symbolic import de_casteljau
    >>> t = sp.Symbol("t")
    >>> tape = compile_tape({"curve": de_casteljau([[0, 0], [1, 2], [2, 0]], t)[-1][0]}, [t])
    >>> tape.run([0.5])["curve"]
    array([1., 1.])
    """
    inputs = tuple(inputs)
    _refuse_duplicates(inputs)
    program = Program(inputs)
    roots: dict[str, tuple[tuple[int, ...], list[int]]] = {}
    for name, value in outputs.items():
        shape, flat = flattened(value)
        roots[name] = shape, program.add(flat)
    live = program.live(i for _, numbers in roots.values() for i in numbers)
    constants = [i for i in live if program.nodes[i][0] == "constant"]
    instructions = [i for i in live if program.nodes[i][0] not in ("input", "constant")]
    inputs_first = [*program.inputs.values(), *constants, *instructions]
    register = {node: r for r, node in enumerate(inputs_first)}
    return Tape(
        tuple(program.inputs),
        tuple(program.nodes[i][1] for i in constants),
        tuple(
            (program.nodes[i][0], *(register[a] for a in program.nodes[i][1:]))
            for i in instructions
        ),
        {
            name: Output(shape, tuple(register[i] for i in numbers))
            for name, (shape, numbers) in roots.items()
        },
    )


def _refuse_duplicates(inputs: Sequence[sp.Symbol]) -> None:
    names = [symbol.name if isinstance(symbol, sp.Symbol) else None for symbol in inputs]
    if None in names or len(set(names)) != len(names):
        raise BadType("distinct symbols as inputs", shown(list(inputs)), "Name each once.")


def flattened(value: Any) -> tuple[tuple[int, ...], list[sp.Expr]]:
    """Return the shape of an expression or a nested list of them, and its entries row by row.

    >>> flattened([[1, 2], [3, 4]])
    ((2, 2), [1, 2, 3, 4])
    """
    entries = as_list(value)
    if entries is None:
        return (), [_scalar(value)]
    value = entries
    if not value:
        raise BadValue("at least one expression", "an empty list", "Leave the output out.")
    parts = [flattened(entry) for entry in value]
    shapes = {shape for shape, _ in parts}
    if len(shapes) > 1:
        raise BadValue("rows of equal length", shown(value), "Fill the rows up.")
    inner = next(iter(shapes), ())
    return (len(parts), *inner), [expression for _, entries in parts for expression in entries]


def _scalar(value: Any) -> sp.Expr:
    if isinstance(value, sp.Expr) and not isinstance(value, sp.MatrixExpr):
        return value  # floats inside are welcome here, where everything becomes one
    return sp.Float(value) if isinstance(value, float) else exact(value)
