/**
 * Interpreter of the tape: a straight-line program given as data, so that the browser computes
 * the very expressions Python derived, without eval and without asking the kernel.
 *
 * A register is one number, or one number per sample of ONE axis. All registers live in one
 * Float64Array, laid out once by `load`; `run` allocates nothing. An output that depends on an
 * axis is flat and sample-major: component c of sample s is `values[s * size + c]`, and the
 * components themselves are row-major in the output's shape.
 */

/** @typedef {import("./scene.js").TapeData} TapeData */
/** @typedef {import("./scene.js").Axis} Axis */
/** @typedef {{shape: number[], size: number, axis: number | null, count: number, values: Float64Array}} Output */
/** @typedef {(m: Float64Array, o: number, a: number, b: number, n: number, da: number, db: number) => void} Kernel */
/** @typedef {{start: number, axis: number | null, live: boolean}} Register  live: depends on an input */

/**
 * The four operations that dominate, one loop for every combination of vector and scalar. Written
 * out instead of composed: a shared loop calling a function per element is five times slower.
 * @type {Record<string, {vv: Kernel, vs: Kernel, sv: Kernel, ss: Kernel}>}
 */
const ARITHMETIC = {
  add: {
    vv: (m, o, a, b, n) => { for (let i = 0; i < n; i++) m[o + i] = m[a + i] + m[b + i]; },
    vs: (m, o, a, b, n) => { const s = m[b]; for (let i = 0; i < n; i++) m[o + i] = m[a + i] + s; },
    sv: (m, o, a, b, n) => { const s = m[a]; for (let i = 0; i < n; i++) m[o + i] = s + m[b + i]; },
    ss: (m, o, a, b) => { m[o] = m[a] + m[b]; },
  },
  sub: {
    vv: (m, o, a, b, n) => { for (let i = 0; i < n; i++) m[o + i] = m[a + i] - m[b + i]; },
    vs: (m, o, a, b, n) => { const s = m[b]; for (let i = 0; i < n; i++) m[o + i] = m[a + i] - s; },
    sv: (m, o, a, b, n) => { const s = m[a]; for (let i = 0; i < n; i++) m[o + i] = s - m[b + i]; },
    ss: (m, o, a, b) => { m[o] = m[a] - m[b]; },
  },
  mul: {
    vv: (m, o, a, b, n) => { for (let i = 0; i < n; i++) m[o + i] = m[a + i] * m[b + i]; },
    vs: (m, o, a, b, n) => { const s = m[b]; for (let i = 0; i < n; i++) m[o + i] = m[a + i] * s; },
    sv: (m, o, a, b, n) => { const s = m[a]; for (let i = 0; i < n; i++) m[o + i] = s * m[b + i]; },
    ss: (m, o, a, b) => { m[o] = m[a] * m[b]; },
  },
  div: {
    vv: (m, o, a, b, n) => { for (let i = 0; i < n; i++) m[o + i] = m[a + i] / m[b + i]; },
    vs: (m, o, a, b, n) => { const s = m[b]; for (let i = 0; i < n; i++) m[o + i] = m[a + i] / s; },
    sv: (m, o, a, b, n) => { const s = m[a]; for (let i = 0; i < n; i++) m[o + i] = s / m[b + i]; },
    ss: (m, o, a, b) => { m[o] = m[a] / m[b]; },
  },
};

/**
 * C's pow, which NumPy follows: 1 to any power, and -1 to an infinite one, are 1.
 * @param {number} x
 * @param {number} y
 */
const power = (x, y) => (x === 1 || (x === -1 && Math.abs(y) === Infinity) ? 1 : x ** y);

/** @type {Record<string, (x: number) => number>} */
const UNARY = {
  neg: (x) => -x, sqrt: Math.sqrt, sin: Math.sin, cos: Math.cos, tan: Math.tan,
  exp: Math.exp, log: Math.log, abs: Math.abs,
  step: (x) => (x >= 0 ? 1 : x < 0 ? 0 : NaN),
};

/** @type {Record<string, (x: number, y: number) => number>} */
const BINARY = {
  pow: power, atan2: Math.atan2, min: Math.min, max: Math.max, ratio: (x, y) => (y === 0 ? 0 : x / y),
};

/** @type {(f: (x: number, y: number) => number) => Kernel} */
const elementwise = (f) => (m, o, a, b, n, da, db) => {
  for (let i = 0; i < n; i++, a += da, b += db) m[o + i] = f(m[a], m[b]);
};

/**
 * @param {string} name
 * @returns {{arity: 1 | 2, kernel: (aVector: boolean, bVector: boolean) => Kernel}}
 */
function operation(name) {
  const loops = Object.hasOwn(ARITHMETIC, name) && ARITHMETIC[name];
  if (loops) {
    return { arity: 2, kernel: (a, b) => (a ? (b ? loops.vv : loops.vs) : b ? loops.sv : loops.ss) };
  }
  for (const [table, arity] of /** @type {const} */ ([[UNARY, 1], [BINARY, 2]])) {
    if (Object.hasOwn(table, name)) {
      const kernel = elementwise(table[name]);
      return { arity, kernel: () => kernel };
    }
  }
  throw new Error(`The figure's tape uses the operation "${name}", which its front end does not know: `
    + "figure and front end come from different versions of casteljau. Run the cell again, or reinstall casteljau.");
}

/** The axis a value depends on when it is made of these registers; one axis at most. */
function commonAxis(/** @type {Register[]} */ registers, /** @type {string} */ what) {
  let axis = /** @type {number | null} */ (null);
  for (const register of registers) {
    if (register.axis === null || register.axis === axis) continue;
    if (axis !== null) {
      throw new Error(`Expected ${what} to depend on one sampled axis at most; received one that `
        + `depends on axes ${axis} and ${register.axis}. Split it into two outputs.`);
    }
    axis = register.axis;
  }
  return axis;
}

/** Samples of an axis, bit for bit those of numpy.linspace. */
function fillAxis(/** @type {Float64Array} */ memory, /** @type {number} */ start, /** @type {Axis} */ axis) {
  const step = axis.count > 1 ? (axis.high - axis.low) / (axis.count - 1) : 0;
  for (let i = 0; i < axis.count; i++) memory[start + i] = axis.low + i * step;
  if (axis.count > 1) memory[start + axis.count - 1] = axis.high;
}

/**
 * Give every input, constant and instruction its register, and every instruction its kernel.
 * @param {TapeData} tape
 * @param {Axis[]} axes
 */
function compile(tape, axes) {
  /** @type {Register[]} */
  const registers = [];
  let size = 0;
  const allot = (/** @type {number | null} */ axis, /** @type {boolean} */ live) => {
    registers.push({ start: size, axis, live });
    size += axis === null ? 1 : axes[axis].count;
    return registers[registers.length - 1];
  };
  const scalars = tape.inputs.length - axes.length;
  tape.inputs.forEach((_, i) => (i < scalars ? allot(null, true) : allot(i - scalars, false)));
  tape.constants.forEach(() => allot(null, false));

  const operations = tape.operations.map(operation);
  const program = [];
  for (let k = 0; k < tape.code.length;) {
    const { arity, kernel } = operations[tape.code[k]];
    const a = registers[tape.code[k + 1]];
    const b = arity === 2 ? registers[tape.code[k + 2]] : a;
    k += 1 + arity;
    const target = allot(commonAxis([a, b], "every value of a figure"), a.live || b.live);
    const [da, db] = [a.axis === null ? 0 : 1, b.axis === null ? 0 : 1];
    program.push({ run: kernel(da === 1, db === 1), o: target.start, a: a.start, b: b.start,
      n: size - target.start, da, db, live: target.live });
  }
  return { registers, program, size, scalars };
}

/**
 * Prepare a tape for running.
 * @param {TapeData} tape
 * @param {Axis[]} axes  the last `axes.length` inputs of the tape, in order
 * @returns {{outputs: Record<string, Output>, run: (inputs: ArrayLike<number>) => void}}
 */
export function load(tape, axes) {
  const { registers, program, size, scalars } = compile(tape, axes);
  const memory = new Float64Array(size);
  axes.forEach((axis, j) => fillAxis(memory, registers[scalars + j].start, axis));
  tape.constants.forEach((value, i) => {
    const { start } = registers[tape.inputs.length + i];
    memory[start] = Array.isArray(value) ? value[0] / value[1] : value;
  });
  // What no input reaches is computed here, once: powers of a sampled t, for example.
  for (const step of program) {
    if (!step.live) step.run(memory, step.o, step.a, step.b, step.n, step.da, step.db);
  }
  const live = program.filter((step) => step.live);

  const gathers = Object.entries(tape.outputs).map(([name, output]) => {
    const sources = output.registers.map((r) => registers[r]);
    const axis = commonAxis(sources, `output "${name}"`);
    const count = axis === null ? 1 : axes[axis].count;
    return { name, shape: output.shape, size: sources.length, axis, count, sources,
      values: new Float64Array(count * sources.length) };
  });

  function run(/** @type {ArrayLike<number>} */ inputs) {
    if (inputs.length !== scalars) {
      throw new Error(`Expected ${scalars} input values for the tape; received ${inputs.length}.`);
    }
    for (let i = 0; i < scalars; i++) memory[i] = inputs[i];
    for (const step of live) step.run(memory, step.o, step.a, step.b, step.n, step.da, step.db);
    for (const { values, sources, size: width, count } of gathers) {
      for (let c = 0; c < width; c++) {
        const stride = sources[c].axis === null ? 0 : 1;
        let from = sources[c].start;
        for (let s = 0; s < count; s++, from += stride) values[s * width + c] = memory[from];
      }
    }
  }

  return { outputs: Object.fromEntries(gathers.map((output) => [output.name, output])), run };
}
