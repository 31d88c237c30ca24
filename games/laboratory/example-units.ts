/** The units of examples whose lengths are pixels, in the general plots of their pages. */

type OwnUnits = Readonly<Record<string, string>>;

const PIXELS: OwnUnits = {
  m: 'px',
  'm/s': 'px/s',
  'm/s²': 'px/s²',
  N: 'kg px/s²',
  J: 'kg px²/s²',
  'kg m/s': 'kg px/s',
  'kg m²/s': 'kg px²/s',
};

/** What the units of an example are read from: the labels of its plots. */
interface Labelled {
  readonly x?: { readonly label: string };
  readonly y: { readonly label: string };
}

/** Units by the SI units that plots show otherwise: those of pixels where a plot of the example has them. */
export function unitsOf(plots: readonly Labelled[]): OwnUnits {
  const isInPixels = ({ x, y }: Labelled) => [x?.label ?? '', y.label].some((label) => /\bpx/.test(label));
  return plots.some(isInPixels) ? PIXELS : {};
}
