/** Texts in three dimensions: they face the viewer and are of the same size at any distance. */
import { COLORS, type Color, type Point } from '@principia/scenes/examples';
import { CanvasTexture, Group, LinearFilter, type PerspectiveCamera, Sprite, SpriteMaterial } from 'three';

/** Height of a text, CSS pixels, of the pixels in which it is drawn, for sharp screens, and distance from its point. */
const [HEIGHT, DRAWN, GAP] = [17, 40, 4];
const FONT = `${0.75 * DRAWN}px system-ui, sans-serif`;

interface Label {
  readonly sprite: Sprite;
  readonly context: CanvasRenderingContext2D;
  text: string;
}

export class LabelSprites {
  readonly object = new Group();
  readonly #labels: Label[] = [];
  #used = 0;

  begin(): void {
    this.#used = 0;
  }

  /** Writes to the upper right of a point. */
  write({ x, y, z = 0 }: Point, text: string, color: Color = COLORS.white): void {
    const label = this.#labels[this.#used] ?? this.#add();
    this.#used++;
    label.sprite.visible = true;
    label.sprite.position.set(x, y, z);
    label.sprite.material.color.set(color);
    if (label.text !== text) draw(label, text);
  }

  /** Hides the texts that were not written since `begin`. */
  end(): void {
    for (let i = this.#used; i < this.#labels.length; i++) this.#labels[i].sprite.visible = false;
  }

  destroy(): void {
    for (const { sprite } of this.#labels) {
      sprite.material.map?.dispose();
      sprite.material.dispose();
    }
  }

  #add(): Label {
    const context = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
    const material = new SpriteMaterial({ sizeAttenuation: false, depthTest: false, transparent: true });
    const sprite = new Sprite(material);
    sprite.renderOrder = 1;
    sprite.onBeforeRender = ({ domElement }, _, camera) => {
      const { canvas } = context;
      // Without attenuation a scale of 1 is the height at a distance of 1.
      const high = 2 * Math.tan(((camera as PerspectiveCamera).fov * Math.PI) / 360);
      const scale = (HEIGHT / Math.max(1, domElement.clientHeight)) * high;
      sprite.scale.set((scale * canvas.width) / canvas.height, scale, 1);
      sprite.center.set((-GAP * canvas.height) / (HEIGHT * canvas.width), -GAP / HEIGHT);
      sprite.updateMatrixWorld();
    };
    const label = { sprite, context, text: '' };
    this.#labels.push(label);
    this.object.add(sprite);
    return label;
  }
}

/** A texture cannot change its size, so another text gets another one. */
function draw(label: Label, text: string): void {
  const { context, sprite } = label;
  const { canvas } = context;
  context.font = FONT;
  canvas.width = Math.max(1, Math.ceil(context.measureText(text).width));
  canvas.height = DRAWN;
  context.font = FONT;
  context.fillStyle = '#fff';
  context.textBaseline = 'middle';
  context.fillText(text, 0, DRAWN / 2);
  sprite.material.map?.dispose();
  sprite.material.map = new CanvasTexture(canvas);
  sprite.material.map.minFilter = LinearFilter;
  sprite.material.map.generateMipmaps = false;
  sprite.material.needsUpdate = true;
  label.text = text;
}
