/** The objects and the ground of a world, as geometries. */
import * as THREE from "three";
import { gridStep } from "crs/units.js";

/** @param {import("./scene.js").Shape} shape */
export function shapeGeometry(shape) {
  if (shape.radius) {
    const drum = new THREE.CylinderGeometry(shape.radius, shape.radius, shape.height, 40);
    return drum.rotateX(Math.PI / 2).translate(0, 0, shape.height / 2);
  }
  const outline = new THREE.Shape((shape.corners ?? []).map(([x, y]) => new THREE.Vector2(x, y)));
  return new THREE.ExtrudeGeometry(outline, { depth: shape.height, bevelEnabled: false });
}

/** A disc for the top of something warm: red with a white rim, to be seen on any colour. @param {import("./scene.js").Shape} shape */
export function heatMark(shape) {
  const corners = shape.corners ?? [];
  const span = (axis) => Math.max(...corners.map((each) => each[axis])) - Math.min(...corners.map((each) => each[axis]));
  const size = shape.radius ?? Math.min(span(0), span(1)) / 2;
  const mark = new THREE.Group();
  for (const { share, colour, rise } of [
    { share: 0.7, colour: "#ffffff", rise: 0.004 },
    { share: 0.52, colour: "#d1242f", rise: 0.008 },
  ]) {
    const disc = new THREE.Mesh(new THREE.CircleGeometry(share * Math.min(0.4, size), 32), new THREE.MeshBasicMaterial({ color: colour }));
    disc.position.z = shape.height + rise;
    mark.add(disc);
  }
  return mark;
}

/** Add the floor, its ramps, and its map of heights; return the floor. */
export function addGround(world, scene) {
  const { x, y, length, width } = scene.area;
  const material = new THREE.MeshLambertMaterial({ color: "#ffffff" });
  const { map, patches } = scene.ground;
  const floor = new THREE.Mesh(map ? mapGeometry(scene) : new THREE.PlaneGeometry(length, width), material);
  if (!map) floor.position.set(x + length / 2, y + width / 2, 0);
  floor.receiveShadow = true;
  world.add(floor);
  for (const patch of patches) {
    const mesh = new THREE.Mesh(rampGeometry(patch), new THREE.MeshLambertMaterial({ color: "#c9cdb9" }));
    mesh.position.set(patch.x, patch.y, 0.002);
    mesh.rotation.z = patch.heading;
    mesh.castShadow = mesh.receiveShadow = true;
    world.add(mesh);
  }
  return floor;
}

/** Add lines on a floor without hills, a metre apart, or more in large worlds. */
export function addGrid(world, scene) {
  const { x, y, length, width } = scene.area;
  const vast = Math.max(length, width) > 200;
  const [left, right, low, high] = vast ? [-100, 100, -100, 100] : [x, x + length, y, y + width];
  const step = gridStep(Math.max(1, (right - left) / 200));
  const places = [];
  for (let at = Math.ceil(left / step) * step; at <= right; at += step) places.push(at, low, 0, at, high, 0);
  for (let at = Math.ceil(low / step) * step; at <= high; at += step) places.push(left, at, 0, right, at, 0);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(scene.ground.map ? [] : places, 3));
  const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial());
  lines.position.z = 0.004;
  world.add(lines);
  return lines;
}

function mapGeometry(scene) {
  const { map } = scene.ground;
  const [rows, columns] = [map.heights.length, map.heights[0].length];
  const plane = new THREE.PlaneGeometry(1, 1, columns - 1, rows - 1);
  const place = plane.attributes.position;
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < columns; column++) {
      const index = (rows - 1 - row) * columns + column;
      place.setXYZ(index, map.x + column * map.pixel, map.y + row * map.pixel, map.heights[row][column]);
    }
  }
  plane.computeVertexNormals();
  return plane;
}

/** A wedge, or a block if both its ends are as high. */
function rampGeometry(patch) {
  const [l, from, to] = [patch.length / 2, Math.max(0.002, patch.from), Math.max(0.002, patch.to)];
  const side = new THREE.Shape([
    new THREE.Vector2(-l, 0),
    new THREE.Vector2(l, 0),
    new THREE.Vector2(l, to),
    new THREE.Vector2(-l, from),
  ]);
  const wedge = new THREE.ExtrudeGeometry(side, { depth: patch.width, bevelEnabled: false });
  return wedge.rotateX(Math.PI / 2).translate(0, patch.width / 2, 0);
}

/** Add the lamps that the world names: a bulb on a stand, with its light. */
export function addLamps(world, scene) {
  for (const lamp of (scene.run.world.lights ?? []).slice(0, 8)) {
    const z = scene.ground.height(lamp.x, lamp.y);
    const bulb = new THREE.Mesh(new THREE.SphereGeometry(0.07, 20, 12), new THREE.MeshBasicMaterial({ color: "#ffe9b0" }));
    bulb.position.set(lamp.x, lamp.y, z + 0.75);
    const stand = new THREE.Mesh(new THREE.CylinderGeometry(0.012, 0.02, 0.7, 12), new THREE.MeshLambertMaterial({ color: "#555b66" }));
    stand.rotation.x = Math.PI / 2;
    stand.position.set(lamp.x, lamp.y, z + 0.35);
    const light = new THREE.PointLight("#ffd890", Math.min(8, 3 * lamp.brightness), 6, 1.6);
    light.position.copy(bulb.position);
    world.add(bulb, stand, light);
  }
}

/** Add the sources and nests: flat discs, drawn on top of the floor. */
export function addPlaces(world, scene) {
  for (const { x, y, radius, colour } of scene.run.world.places ?? []) {
    const material = new THREE.MeshBasicMaterial({ color: colour, transparent: true, opacity: 0.25, depthWrite: false });
    const disc = new THREE.Mesh(new THREE.CircleGeometry(radius, 48), material);
    disc.position.set(x, y, scene.ground.height(x, y) + 0.004);
    world.add(disc);
  }
}
