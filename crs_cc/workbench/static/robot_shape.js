/** The bodies of robots, by the definition of their kind: what is painted, and what is not. */
import * as THREE from "three";

const DARK = [0.09, 0.1, 0.12];
const RUBBER = [0.05, 0.05, 0.06];
const WHITE = [1, 1, 1];
const GOLD = [0.72, 0.6, 0.3];

/** Join geometries into one, each with a colour for all its corners. */
export function joined(parts) {
  const plain = parts.map(([geometry, colour]) => [geometry.index ? geometry.toNonIndexed() : geometry, colour]);
  const count = plain.reduce((sum, [geometry]) => sum + geometry.attributes.position.count, 0);
  const [places, normals, colours] = [0, 1, 2].map(() => new Float32Array(count * 3));
  let at = 0;
  for (const [geometry, colour] of plain) {
    const { position, normal } = geometry.attributes;
    places.set(position.array, at * 3);
    normals.set(normal.array, at * 3);
    for (let corner = 0; corner < position.count; corner++) colours.set(colour, (at + corner) * 3);
    at += position.count;
  }
  const whole = new THREE.BufferGeometry();
  whole.setAttribute("position", new THREE.BufferAttribute(places, 3));
  whole.setAttribute("normal", new THREE.BufferAttribute(normals, 3));
  whole.setAttribute("color", new THREE.BufferAttribute(colours, 3));
  return whole;
}

/** An upright cylinder: from one height to another. */
function drum(radius, low, high, sides, top = radius) {
  const geometry = new THREE.CylinderGeometry(top, radius, high - low, sides);
  return geometry.rotateX(Math.PI / 2).translate(0, 0, (low + high) / 2);
}

/**
 * The geometries of a kind of robot: what is painted, what is not, and what turns with its turret.
 * @param {any} kind its definition; nothing for one that is not known
 * @param {number} radius @param {boolean} isNear whether there are few enough for details
 */
export function robotShape(kind, radius, isNear) {
  const height = kind?.height ?? 0.35;
  const foot = Math.min(0.05, height * 0.15);
  if (!isNear) {
    const nose = new THREE.BoxGeometry(radius * 0.8, radius * 0.2, 0.02).translate(radius * 0.5, 0, height);
    return { painted: joined([[drum(radius, 0, height, 10), WHITE]]), plain: joined([[new THREE.BoxGeometry(0.01, 0.01, 0.01), DARK]]), top: joined([[nose, WHITE]]) };
  }
  const body = radius * 0.96;
  const painted = joined([
    [drum(body, foot, height * 0.62, 40), WHITE],
    [drum(body, height * 0.78, height, 40, body * 0.94), WHITE],
  ]);
  const plain = [
    [drum(body * 0.97, height * 0.62, height * 0.78, 40), DARK],
    [drum(radius, foot + 0.015, foot + 0.05, 40), RUBBER],
    ...wheels(kind, radius),
  ];
  const top = [[pointer(body * 0.66, height + 0.006), WHITE], ...sonars(kind, height * 0.7), ...turret(kind, body, height)];
  return { painted, plain: joined(plain), top: joined(top) };
}

/** An arrowhead on the top, ahead. */
function pointer(size, z) {
  const outline = new THREE.Shape();
  outline.moveTo(size, 0);
  outline.lineTo(-0.45 * size, 0.55 * size);
  outline.lineTo(-0.15 * size, 0);
  outline.lineTo(-0.45 * size, -0.55 * size);
  return new THREE.ShapeGeometry(outline).translate(0, 0, z);
}

/** What shows where a turret looks: a bar across its front. */
function turret(kind, body, height) {
  if (!kind?.turret) return [];
  const bar = new THREE.BoxGeometry(body * 0.28, body * 0.5, height * 0.1).translate(body * 0.82, 0, height * 0.9);
  return [[bar, DARK]];
}

function wheels(kind, radius) {
  const size = radius * 0.38;
  const half = (kind?.wheel_base || radius * 1.7) / 2;
  const wheel = (x, y) => {
    const made = new THREE.CylinderGeometry(size, size, radius * 0.14, 24).translate(x, 0, y);
    return [made.rotateX(Math.PI / 2).translate(0, 0, size), RUBBER];
  };
  if (kind?.steers) {
    return [0, 1, 2].map((number) => {
      const angle = (number * 2 * Math.PI) / 3;
      return wheel(radius * 0.6 * Math.cos(angle), radius * 0.6 * Math.sin(angle));
    });
  }
  const caster = new THREE.SphereGeometry(size * 0.4, 12, 8).translate(-radius * 0.7, 0, size * 0.4);
  return [wheel(0, half), wheel(0, -half), [caster, RUBBER]];
}

function sonars(kind, z) {
  return (kind?.sonars ?? []).map(({ x, y, direction }) => {
    const disc = new THREE.CylinderGeometry(0.019, 0.019, 0.012, 16).rotateZ(Math.PI / 2);
    return [disc.rotateZ(direction).translate(x * 0.96, y * 0.96, z), GOLD];
  });
}
