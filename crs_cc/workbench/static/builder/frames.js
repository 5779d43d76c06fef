/** Coordinates of definitions: what is in the frame of an object, and in that of the world. */

/** @typedef {[number, number, number]} Pose x, y [m] and heading [rad] */

/** The motion from the frame at a pose to the one around it. @param {Pose} pose */
export function outOf([x, y, heading]) {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return ([px, py]) => [x + cos * px - sin * py, y + sin * px + cos * py];
}

/** The motion into the frame at a pose. @param {Pose} pose */
export function into([x, y, heading]) {
  const [cos, sin] = [Math.cos(heading), Math.sin(heading)];
  return ([px, py]) => [cos * (px - x) + sin * (py - y), cos * (py - y) - sin * (px - x)];
}

/** A pose in the frame at another pose, seen from around that. @param {Pose} outer @param {Pose} inner @returns {Pose} */
export function compose(outer, inner) {
  const [x, y] = outOf(outer)([inner[0], inner[1]]);
  return [x, y, outer[2] + inner[2]];
}

/** A shape after a motion of the plane. */
export function moved(shape, motion) {
  if (shape.points) return { ...shape, points: shape.points.map(motion) };
  const [x, y] = motion([shape.x, shape.y]);
  const ahead = motion([shape.x + Math.cos(shape.heading ?? 0), shape.y + Math.sin(shape.heading ?? 0)]);
  return { ...shape, x, y, heading: Math.atan2(ahead[1] - y, ahead[0] - x) };
}

/**
 * The shapes of an object by its parts, in its frame.
 * @param {any[]} shapes @param {Pose} pose @param {{name: string}[]} parts @param {string} root the definition's name
 */
export function byPart(shapes, pose, parts, root) {
  const motion = into(pose);
  const own = parts.map((part) => part.name.slice(root.length + 1));
  /** @type {Record<string, any[]>} */
  const found = {};
  for (const shape of shapes) {
    const index = own.findIndex((name) => shape.part === name || shape.part?.startsWith(`${name}.`));
    if (index < 0) continue;
    const inner = { ...moved(shape, motion), part: shape.part.slice(own[index].length + 1) };
    (found[parts[index].name] ??= []).push(inner);
  }
  return found;
}
