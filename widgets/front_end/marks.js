/**
 * The marks of a drawing: a table from the kind of a mark to the function that draws it. A new
 * visual idea is a new line in this table.
 *
 * Each function makes its elements once and returns `update`, which moves them: elements and
 * strings change on every frame of a drag, and nothing else does.
 */

import { attributeWriter, svg } from "./dom.js";
import { cssColour } from "./theme.js";

/** @typedef {import("./scene.js").Mark} Mark */
/** @typedef {import("./tape.js").Output} Output */
/** @typedef {import("./transform.js").Transform} Transform */
/** @typedef {ReturnType<typeof import("./labels.js").createLabels>} Labels */
/** @typedef {{nodes: SVGElement[], update: (map: Transform, shown: boolean) => void}} Drawn */
/** @typedef {(mark: Mark, output: Output, labels: Labels, rank: number) => Drawn} Renderer */

/** Browsers draw coordinates beyond this wrongly; it is far outside of any screen. */
const FAR = 1e5;
const pixel = (/** @type {number} */ v) => Math.round(Math.min(Math.max(v, -FAR), FAR) * 100) / 100;

/**
 * The path through an output's points, `pieces[k]` of its pieces (points, for a polyline) in the
 * k-th subpath. It breaks where a coordinate is not finite.
 * @param {Output} output
 * @param {Mark} mark
 * @param {Transform} map
 * @param {Labels} labels
 */
function pathData({ values, size, count }, mark, map, labels) {
  let d = "";
  let piece = 0;
  for (const length of mark.pieces ?? [size / 2]) {
    let pen = false;
    let whole = true;
    for (const end = piece + length; piece < end; piece++) {
      for (let k = 2 * piece; k < count * size; k += size) {
        const x = map.sx * values[k] + map.ox;
        const y = map.sy * values[k + 1] + map.oy;
        if (Number.isFinite(x) && Number.isFinite(y)) {
          d += `${pen ? "L" : "M"}${pixel(x)} ${pixel(y)}`;
          labels.line(x, y, !pen);
          pen = true;
        } else pen = whole = false;
      }
    }
    if (mark.closed && whole) d += "Z";
  }
  return d;
}

/** @type {Renderer} */
function path(mark, output, labels) {
  const style = `--colour: ${cssColour(mark.color)}; --width: ${mark.width ?? 2}px`;
  // A line in the accent's colour is emphasis already.
  const halo = svg("path", { class: mark.color === "accent" ? "none" : "halo", style });
  const line = svg("path", { class: `path${mark.fill ? " filled" : ""}${mark.dashed ? " dashed" : ""}`, style });
  const [writeHalo, writeLine] = [attributeWriter(halo, "d"), attributeWriter(line, "d")];
  return {
    nodes: [halo, line],
    update(map, shown) {
      if (!shown) return;
      const d = pathData(output, mark, map, labels);
      writeHalo(d);
      writeLine(d);
    },
  };
}

/** @type {Renderer} */
function dots(mark, output, labels, rank) {
  const radius = mark.radius ?? 5;
  const all = Array.from({ length: output.size / 2 }, (_, i) => {
    const colour = cssColour(mark.colors?.[i]);
    const text = mark.labels?.[i];
    return {
      node: svg("g", { style: `--colour: ${colour}` },
        svg("circle", { class: "halo", r: radius + 5 }), svg("circle", { class: "dot", r: radius })),
      label: text ? labels.add(text, colour, rank, radius + 5) : null,
    };
  });
  return {
    nodes: all.map(({ node }) => node),
    update(map, shown) {
      all.forEach(({ node, label }, i) => {
        const x = map.sx * output.values[2 * i] + map.ox;
        const y = map.sy * output.values[2 * i + 1] + map.oy;
        const visible = shown && Number.isFinite(x) && Number.isFinite(y);
        node.style.display = visible ? "" : "none";
        if (label) [label.x, label.y, label.wanted] = [x, y, visible];
        if (!visible) return;
        node.setAttribute("transform", `translate(${pixel(x)} ${pixel(y)})`);
        labels.point(x, y, radius);
      });
    },
  };
}

/** Arrows stop this far from their end, so that they do not hide below a point there. */
const ARROW_GAP = 8;

/** Shaft and head of an arrow in pixels; nothing where it has no direction. */
function arrow(/** @type {number[]} */ [x0, y0, toX, toY], /** @type {number} */ width) {
  const length = Math.hypot(toX - x0, toY - y0) - ARROW_GAP;
  if (!(length > 1 && length < FAR)) return ["", ""];
  const [ux, uy] = [(toX - x0) / (length + ARROW_GAP), (toY - y0) / (length + ARROW_GAP)];
  const [x1, y1] = [x0 + ux * length, y0 + uy * length];
  const head = Math.min(7 + 1.5 * width, length);
  const half = head * 0.42;
  const [bx, by] = [x1 - ux * head, y1 - uy * head];
  return [
    `M${pixel(x0)} ${pixel(y0)}L${pixel(bx)} ${pixel(by)}`,
    `M${pixel(x1)} ${pixel(y1)}L${pixel(bx - uy * half)} ${pixel(by + ux * half)}`
    + `L${pixel(bx + uy * half)} ${pixel(by - ux * half)}Z`,
  ];
}

/** @type {Renderer} */
function arrows(mark, output, labels) {
  const width = mark.width ?? 2;
  const style = `--colour: ${cssColour(mark.color)}; --width: ${width}px`;
  const halo = svg("path", { class: "halo", style });
  const shaft = svg("path", { class: "path", style });
  const head = svg("path", { class: "head", style });
  const write = [halo, shaft, head].map((node) => attributeWriter(node, "d"));
  return {
    nodes: [halo, shaft, head],
    update(map, shown) {
      if (!shown) return;
      const all = ["", ""];
      for (let k = 0; k < output.size; k += 4) {
        const [x0, y0, x1, y1] = output.values.subarray(k, k + 4);
        const ends = [map.sx * x0 + map.ox, map.sy * y0 + map.oy, map.sx * x1 + map.ox, map.sy * y1 + map.oy];
        const [line, tip] = arrow(ends, width);
        all[0] += line;
        all[1] += tip;
        if (!line) continue;
        labels.line(ends[0], ends[1], true);
        labels.line(ends[2], ends[3], false);
      }
      write[0](all[0]);
      write[1](all[0]);
      write[2](all[1]);
    },
  };
}

/** Write the corners of the convex hull, by Andrew's monotone chain; the first one also fills up what is left. */
export function convexHull(/** @type {Float64Array} */ values, /** @type {Float64Array} */ corners) {
  const points = Array.from({ length: values.length / 2 }, (_, i) => [values[2 * i], values[2 * i + 1]])
    .sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  const half = () => {
    /** @type {number[][]} */
    const chain = [];
    for (const p of points) {
      for (;;) {
        const [a, b] = chain.slice(-2);
        if (!b || (b[0] - a[0]) * (p[1] - a[1]) > (b[1] - a[1]) * (p[0] - a[0])) break;
        chain.pop();
      }
      chain.push(p);
    }
    points.reverse();
    return chain.slice(0, -1);
  };
  const hull = [...half(), ...half()];
  for (let i = 0; i < points.length; i++) corners.set(hull[i] ?? hull[0], 2 * i);
}

/** @type {Renderer} */
function hull(mark, output, labels) {
  const corners = { ...output, values: new Float64Array(output.size) };
  const { nodes, update } = path({ ...mark, fill: true, closed: true }, corners, labels);
  return {
    nodes,
    update(map, shown) {
      if (shown) convexHull(output.values, corners.values);
      update(map, shown);
    },
  };
}

/** @type {Record<string, Renderer>} */
export const DRAWING_MARKS = { path, hull, dots, arrows };

/** Is a mark there at this step, and is it what the step adds? (Not if it goes again with it.) */
export function presence(/** @type {{from?: number, until?: number | null}} */ mark, /** @type {number} */ step) {
  const from = mark.from ?? 0;
  const until = mark.until ?? Infinity;
  return { shown: step >= from && step <= until, active: from > 0 && step === from && until > from };
}
