import { PhysicsError } from '../errors/physics-error.ts';
import { bodyId, defineComponent, real, u32 } from './define.ts';
import { MAX_POSITION } from './position.ts';
import { MAX_ANGLE } from './rotation.ts';

const COORDINATE = { bounds: { min: -MAX_POSITION, max: MAX_POSITION } };

/**
 * Makes an entity with a Collider a part of a compound body: its shape moves rigidly with the body, which has the mass. Its
 * Position and Rotation follow at the end of each step. `spawnCompound` makes such bodies. Rigid bodies of two dimensions.
 */
export const Attachment = defineComponent({
  fields: {
    /** The body that it belongs to, by id, and which life of that id is meant; the engine fills in the latter. */
    body: bodyId('bodyGeneration', true),
    bodyGeneration: u32(''),
    /** The position of the part in the frame of the body, whose origin is the centre of mass. */
    x: real('m', COORDINATE),
    y: real('m', COORDINATE),
    /** The angle of the part from that of the body. */
    angle: real('rad', { bounds: { min: -MAX_ANGLE, max: MAX_ANGLE } }),
  },
  complete({ body }, entity) {
    if (body !== 0 && body !== entity) return;
    const problem = body === 0 ? 'attachment needs a body.' : `attachment attaches body ${body} to itself.`;
    throw new PhysicsError('E_RANGE', problem, {
      entity,
      field: 'attachment.body',
      value: body,
      hint: 'Give the id of another body, which the shape is a part of.',
    });
  },
});
