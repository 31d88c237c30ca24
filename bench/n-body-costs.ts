// Data of the chart in docs/n-body.md: the cost of a force evaluation by direct summation and by the tree.
import { step } from '@principia/physics';
import { nbodyDirect, nbodyTree, type SceneRun } from '@principia/scenes';
import { countsBetween, measureScaling } from './scaling.ts';
import { type ScalingLine, scalingChart } from './scaling-chart.ts';

const advanceOf =
  ({ world, dt }: SceneRun) =>
  () =>
    step(world, dt);

function line(name: string, create: (count: number) => SceneRun, from: number, to: number): ScalingLine {
  return { name, points: measureScaling(create, countsBetween(from, to), advanceOf, () => {}) };
}

/** Returns the chart as SVG; takes a minute. */
export function costChart(): string {
  const tree = (dimensions: 2 | 3, falloff: number) => (count: number) =>
    nbodyTree.create({ count, dimensions, falloff });
  return scalingChart([
    line('tree, 3D', tree(3, 2), 1e3, 1e6),
    line('tree, 2D, 1/r', tree(2, 1), 1e3, 1e6),
    line('direct sum, 3D', (count) => nbodyDirect.create({ count, dimensions: 3 }), 1e3, 1e5),
  ]);
}
