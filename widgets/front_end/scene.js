/**
 * The shapes of the data a figure is made of. Python writes a scene (`widgets/scene.py`),
 * this folder reads it; nothing here runs.
 *
 * @typedef {{low: number, high: number, count: number}} Axis  a sampled parameter, both ends included
 *
 * @typedef {object} TapeData  a straight-line program; each instruction writes the next register
 * @property {string[]} inputs      names: scalars first, then one for every axis
 * @property {(number | [number, number])[]} constants   a number, or an exact rational [p, q]
 * @property {string[]} operations  names the code refers to by index
 * @property {number[]} code        operation, operand(s), operation, operand(s), ...
 * @property {Record<string, {shape: number[], registers: number[]}>} outputs
 *
 * @typedef {object} View  one drawing
 * @property {string} name
 * @property {string} title
 * @property {[number, number]} x
 * @property {[number, number]} y
 * @property {boolean} equal  one unit is as long in x as in y
 * @property {boolean} axes   draw grid and numbers
 *
 * @typedef {object} PointGroup  movable control points
 * @property {string} name
 * @property {number} view
 * @property {string[]} labels
 * @property {Colour[]} colors
 * @property {[number, number][]} values
 * @property {number | null} snap
 * @property {"x" | null} along  the direction they move in; null: everywhere
 * @property {number} from          first step that has them
 * @property {number | null} until
 *
 * @typedef {object} Slider
 * @property {string} name
 * @property {string} label
 * @property {number} low
 * @property {number} high
 * @property {number} value
 * @property {number | null} snap
 * @property {boolean} play
 *
 * @typedef {number | "curve" | "construction" | "muted" | "accent"} Colour  palette index or role
 *
 * @typedef {object} Mark  something drawn from one output of the tape
 * @property {string} kind
 * @property {string} output
 * @property {number} [view]        drawings only
 * @property {Colour} [color]
 * @property {Colour[]} [colors]
 * @property {number} [from]        first step that shows it; it is emphasised at that step
 * @property {number | null} [until]
 * @property {number | null} [axis]
 * @property {number[] | null} [pieces]
 * @property {boolean} [closed]
 * @property {boolean} [fill]
 * @property {boolean} [dashed]
 * @property {number} [width]
 * @property {number} [radius]
 * @property {string[] | null} [labels]
 * @property {string} [label]
 * @property {string} [title]
 * @property {number[]} [sizes]
 * @property {number[]} [froms]
 * @property {string} [weights]
 * @property {TapeData} [tape]       of a statement: its residuals, computed exactly
 *
 * @typedef {object} Question  asked before the reveal, checked exactly
 * @property {string} prompt
 * @property {TapeData} tape       "answer" and the mistakes, from the figure's inputs and the variables
 * @property {string[]} variables  that may be typed
 * @property {{output: string, message: string}[]} mistakes
 * @property {string} hint         when the answer is wrong in no known way
 * @property {boolean} live        whether the answer depends on the figure's inputs
 * @property {number} from
 * @property {number | null} until
 *
 * @typedef {object} Scene
 * @property {string} version
 * @property {string} title
 * @property {string} description
 * @property {{light: Palette, dark: Palette}} palette
 * @property {View[]} views
 * @property {PointGroup[]} points
 * @property {Slider[]} sliders
 * @property {string[]} steps  captions; empty when the figure has no stepping
 * @property {number} step
 * @property {Axis[]} axes
 * @property {TapeData} tape
 * @property {Mark[]} marks
 * @property {Question[]} questions
 *
 * @typedef {{points: string[], curve: string, construction: string, muted: string, accent: string}} Palette
 *
 * @typedef {object} State  what the learner has changed; small, and the only thing Python is told
 * @property {Record<string, [number, number][]>} points
 * @property {Record<string, number>} sliders
 * @property {number} step
 *
 * @typedef {object} Model  the part of anywidget's model used here
 * @property {(name: string) => any} get
 * @property {(name: string, value: any) => void} set
 * @property {(event: string, callback: () => void) => void} on
 * @property {(event: string, callback: () => void) => void} off
 * @property {() => void} save_changes
 */

export {};
