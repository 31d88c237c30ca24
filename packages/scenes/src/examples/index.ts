/** The examples of the laboratory: each is one file in `chNN`, from which its page, its test and its picture are made. */
export type { Check, CheckState, Moment, Tolerance } from './check.ts';
export {
  type BuildOptions,
  choiceOf,
  defineExample,
  type Example,
  type ExampleAction,
  type ExampleOptions,
  type ExampleParameter,
  type ExamplePointer,
  type ExamplePreset,
  type ExampleRun,
  type ExampleSpec,
  type Histogram,
  type LiveHistogram,
  type LivePlot,
  type PointerEventName,
  type ValuesOf,
} from './define-example.ts';
export type { Expected, Figures } from './figures.ts';
export { type Frame, frameOf } from './frame.ts';
export {
  type Arrow,
  type Axis,
  type CameraKey,
  COLORS,
  type Color,
  type Curve,
  type Dot,
  type Fill,
  type Label,
  type Line,
  type Live,
  now,
  type Picture,
  type Point,
  pointsOf,
  type Trail,
  type ViewBox,
} from './picture.ts';
export type { Plot, PlotOf, Series } from './plot.ts';
