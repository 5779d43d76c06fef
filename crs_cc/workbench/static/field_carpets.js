/** Pheromone fields in three dimensions: carpets on the floor, which is flat where they lie. */
import * as THREE from "three";
import { fieldPixels } from "crs/field_map.js";

const RISE = 0.003; // above the floor and below the next field [m]

export class FieldCarpets {
  /** @param {any} world a scene of three.js */
  constructor(world) {
    this.world = world;
    /** @type {Map<string, {data: string, mesh: any}>} */
    this.all = new Map();
  }

  /** Show these fields and no others. @param {import("./field_map.js").FieldMap[]} fields */
  show(fields) {
    for (const [name, { mesh }] of this.all) mesh.visible = fields.some((field) => field.name === name);
    fields.forEach((field, number) => {
      const before = this.all.get(field.name);
      if (before?.data === field.data) return;
      const carpet = before ?? { data: "", mesh: this.lay(field, number) };
      const picture = new THREE.DataTexture(fieldPixels(field, number), field.columns, field.rows);
      picture.colorSpace = THREE.SRGBColorSpace;
      picture.needsUpdate = true;
      carpet.mesh.material.map?.dispose();
      carpet.mesh.material.map = picture;
      carpet.mesh.material.needsUpdate = !before;
      carpet.data = field.data;
      this.all.set(field.name, carpet);
    });
  }

  /** Add a carpet of the size of a field. */
  lay(field, number) {
    const [length, width] = [field.columns * field.cell, field.rows * field.cell];
    const material = new THREE.MeshBasicMaterial({ transparent: true, depthWrite: false });
    const mesh = new THREE.Mesh(new THREE.PlaneGeometry(length, width), material);
    mesh.position.set(field.x + length / 2, field.y + width / 2, RISE * (number + 1));
    this.world.add(mesh);
    return mesh;
  }
}
