/** What moves on robots: fingers of grippers and links of arms. */
import * as THREE from "three";

const STEEL = "#8a94a3";
const JOINT = "#3b4250";
const MAX = 200; // robots

const made = (geometry, colour) => {
  const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: colour }));
  mesh.castShadow = true;
  return mesh;
};

/** A bar from its origin ahead. */
const bar = (length, width, height, colour) => made(new THREE.BoxGeometry(length, width, height).translate(length / 2, 0, 0), colour);

const joint = (radius, height) => made(new THREE.CylinderGeometry(radius, radius, height, 16).rotateX(Math.PI / 2), JOINT);

export class Limbs {
  /** @param {any} world a scene of three.js */
  constructor(world) {
    this.world = world;
    /** @type {Map<string, any>} by the name of a robot */
    this.all = new Map();
  }

  /** Put the limbs of robots where their devices are. @param {any[]} bodies @param {any} devices */
  place(bodies, devices) {
    const seen = new Set();
    for (const body of bodies.slice(0, MAX)) {
      if (!body.kind?.gripper && !body.kind?.arm) continue;
      seen.add(body.id);
      let limbs = this.all.get(body.id);
      if (!limbs) this.all.set(body.id, (limbs = this.make(body.kind)));
      limbs.group.position.set(body.x, body.y, body.z);
      limbs.group.rotation.z = body.mount;
      this.pose(limbs, body, devices);
    }
    for (const [id, { group }] of this.all) {
      if (seen.has(id)) continue;
      this.world.remove(group);
      this.all.delete(id);
    }
  }

  make(kind) {
    const group = new THREE.Group();
    const limbs = { group, left: null, right: null, upper: null, fore: null };
    if (kind.gripper) {
      const { place, reach } = kind.gripper;
      limbs.left = bar(reach, 0.02, 0.06, STEEL);
      limbs.right = bar(reach, 0.02, 0.06, STEEL);
      for (const finger of [limbs.left, limbs.right]) {
        finger.position.set(place, 0, 0.08);
        group.add(finger);
      }
    }
    if (kind.arm) {
      const { x, y, upper, fore } = kind.arm;
      const z = kind.height + 0.06;
      limbs.upper = new THREE.Group();
      limbs.upper.position.set(x, y, z);
      limbs.fore = new THREE.Group();
      limbs.fore.position.set(upper, 0, 0);
      limbs.fore.add(bar(fore, 0.035, 0.03, STEEL), joint(0.03, 0.05));
      limbs.hand = joint(0.025, 0.09);
      limbs.hand.position.set(fore, 0, -0.02);
      limbs.fore.add(limbs.hand);
      limbs.upper.add(bar(upper, 0.045, 0.035, STEEL), joint(0.04, 0.12), limbs.fore);
      group.add(limbs.upper);
    }
    this.world.add(group);
    return limbs;
  }

  pose(limbs, body, devices) {
    if (limbs.left) {
      const apart = devices?.fingers?.[body.row] ?? body.kind.gripper.opening;
      limbs.left.position.y = apart / 2 + 0.01;
      limbs.right.position.y = -apart / 2 - 0.01;
    }
    if (limbs.upper) {
      const [shoulder, elbow] = devices?.joints?.[body.row] ?? [0, 0];
      limbs.upper.rotation.z = shoulder;
      limbs.fore.rotation.z = elbow;
    }
  }
}
