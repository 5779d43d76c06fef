/** The world in three dimensions, by three.js. z points up. */
import * as THREE from "three";
import { FieldCarpets } from "crs/field_carpets.js";
import { heatPicture, hotObjects, maxHeat } from "crs/heat.js";
import { Limbs } from "crs/limbs.js";
import { robotShape } from "crs/robot_shape.js";
import { addGrid, addGround, addLamps, addPlaces, heatMark, shapeGeometry } from "crs/world_shape.js";

const NEAR_ROBOTS = 400; // more are drawn without details
const NEAR_SOFT = 40; // the same where the processor draws
const DOTS = 2000; // more are dots
const LEAST_PIXELS = 3;

export class View3D {
  /** @param {import("./scene.js").Scene} scene @param {HTMLCanvasElement} canvas */
  constructor(scene, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.isFlat = false;
    this.isSoft = isSoftware();
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !this.isSoft, preserveDrawingBuffer: true });
    this.renderer.shadowMap.enabled = !this.isSoft;
    this.renderer.shadowMap.type = THREE.PCFSoftShadowMap;
    this.wide = new THREE.PerspectiveCamera(42, 1, 0.03, 5000);
    this.flat = new THREE.OrthographicCamera(-1, 1, 1, -1, 0.1, 400);
    this.world = new THREE.Scene();
    this.addSun();
    this.floor = addGround(this.world, scene);
    this.grid = addGrid(this.world, scene);
    addLamps(this.world, scene);
    addPlaces(this.world, scene);
    this.meshes = new Map(scene.shapes.map((shape) => [shape, this.addShape(shape)]));
    /** @type {Map<any, any>} by kind of robot */
    this.groups = new Map();
    this.limbs = new Limbs(this.world);
    this.fields = new FieldCarpets(this.world);
    this.lamps = new THREE.Group();
    this.world.add(this.lamps);
    this.matrix = new THREE.Matrix4();
  }

  addSun() {
    const { x, y, length, width } = this.scene.area;
    const size = Math.min(60, Math.max(length, width));
    this.sun = new THREE.DirectionalLight("#ffffff", 1.9);
    const middle = [x + length / 2, y + width / 2];
    this.sun.position.set(middle[0] - size * 0.5, middle[1] - size * 0.7, size * 1.2);
    this.sun.target.position.set(middle[0], middle[1], 0);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    const camera = this.sun.shadow.camera;
    [camera.left, camera.right, camera.top, camera.bottom] = [-size * 0.8, size * 0.8, size * 0.8, -size * 0.8];
    camera.far = size * 4;
    this.sun.shadow.bias = -0.0005;
    this.sky = new THREE.HemisphereLight("#f6f9ff", "#c9c5bd", 1.55);
    this.world.add(this.sun, this.sun.target, this.sky);
  }

  addShape(shape) {
    const mesh = new THREE.Mesh(shapeGeometry(shape), new THREE.MeshLambertMaterial({ color: shape.colour }));
    mesh.castShadow = mesh.receiveShadow = true;
    this.world.add(mesh);
    return mesh;
  }

  /**
   * @param {any} camera @param {any} body whom it follows @param {any} look
   * @param {boolean} isFine whether edges must be smooth though that takes long
   */
  draw(camera, body, look, isFine = false) {
    const { canvas, renderer } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    this.resize(width, height, this.isSoft ? 1 + Number(isFine) : window.devicePixelRatio || 1);
    this.paint(look);
    this.grid.visible = look.show.grid && !look.heat;
    for (const [shape, mesh] of this.meshes) {
      mesh.position.set(shape.x, shape.y, this.scene.ground.height(shape.x, shape.y) + (shape.lift ?? 0));
      mesh.rotation.z = shape.angle;
      this.markHeat(shape, mesh, look);
    }
    this.fields.show(look.fields);
    this.limbs.place(this.scene.bodies.length > NEAR_ROBOTS ? [] : this.scene.bodies, look.devices);
    const lens = this.aim(camera, body, width, height);
    this.placeRobots(look, camera, width, height);
    renderer.render(this.world, lens);
  }

  /** Set the size of the canvas if it has changed: this clears it and recreates its buffers. */
  resize(width, height, ratio) {
    const key = [width, height, ratio].join();
    if (key === this.size) return;
    this.size = key;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  aim(camera, body, width, height) {
    const { eye, target, up } = camera.pose(body);
    const lens = camera.isFlat ? this.flat : this.wide;
    if (camera.isFlat) {
      const metre = camera.metres(width, height);
      [this.flat.left, this.flat.right] = [(-width / 2) * metre, (width / 2) * metre];
      [this.flat.top, this.flat.bottom] = [(height / 2) * metre, (-height / 2) * metre];
    } else {
      this.wide.aspect = width / height;
    }
    lens.updateProjectionMatrix();
    lens.up.set(up[0], up[1], up[2]);
    lens.position.set(eye[0], eye[1], eye[2]);
    lens.lookAt(target[0], target[1], target[2]);
    lens.updateMatrixWorld();
    this.matrix.multiplyMatrices(lens.projectionMatrix, lens.matrixWorldInverse);
    const e = this.matrix.elements;
    this.project = (x, y, z = 0) => {
      const w = e[3] * x + e[7] * y + e[11] * z + e[15];
      const [px, py] = [e[0] * x + e[4] * y + e[8] * z + e[12], e[1] * x + e[5] * y + e[9] * z + e[13]];
      return [((px / w + 1) / 2) * width, ((1 - py / w) / 2) * height, w];
    };
    const focal = height / 2 / Math.tan((this.wide.fov * Math.PI) / 360);
    this.pixels = (w) => (camera.isFlat ? 1 / camera.metres(width, height) : focal / Math.max(w, 0.01));
    this.lens = lens;
    return lens;
  }

  /** A disc on the top of what is warm, while colours do not show it. */
  markHeat(shape, mesh, look) {
    const isMarked = !look.heat && this.scene.heat(shape) > 0;
    if (isMarked && !mesh.children.length) mesh.add(heatMark(shape));
    for (const mark of mesh.children) mark.visible = isMarked;
  }

  /** Colours of the theme, or of heat. */
  paint(look) {
    const isHeat = Boolean(look.heat);
    const { light } = look;
    if (isHeat) this.warm(look);
    const key = [look.colours.sky, look.colours.floor, isHeat && this.warmed, light.version].join();
    if (key === this.painted) return;
    this.painted = key;
    this.sun.intensity = isHeat ? 0 : 1.9 * light.day; // heat is seen, not lit
    this.sky.intensity = isHeat ? 0 : 0.16 + 1.39 * light.day;
    this.placeLights(light);
    if (!isHeat) this.floor.material.emissiveMap = null;
    this.floor.material.emissive.set(isHeat ? "#ffffff" : "#000000");
    this.floor.material.needsUpdate = true;
    this.world.background = new THREE.Color(isHeat ? look.heat(0) : look.colours.sky);
    if (!isHeat) this.world.background.multiplyScalar(0.12 + 0.88 * light.day);
    this.grid.material.color.set(look.colours.grid).multiplyScalar(0.25 + 0.75 * light.day);
    this.floor.material.color.set(isHeat ? "#000000" : look.colours.floor);
    for (const [shape, mesh] of this.meshes) {
      mesh.material.color.set(isHeat ? look.heat(this.scene.heat(shape)) : shape.colour);
      mesh.material.emissive.set(isHeat ? look.heat(this.scene.heat(shape)) : "#000000");
    }
  }

  /** The sun, and the user's own lamps. @param {import("./lighting.js").Lighting} light */
  placeLights(light) {
    const { x, y, length, width } = this.scene.area;
    const size = Math.min(60, Math.max(length, width));
    const angle = (light.sun * Math.PI) / 180;
    this.sun.position.set(x + length / 2 + 0.86 * size * Math.cos(angle), y + width / 2 + 0.86 * size * Math.sin(angle), size * 1.2);
    this.lamps.clear();
    for (const lamp of light.lamps) {
      const z = this.scene.ground.height(lamp.x, lamp.y) + lamp.z;
      const bulb = new THREE.Mesh(new THREE.SphereGeometry(0.06, 16, 10), new THREE.MeshBasicMaterial({ color: "#fff3cf" }));
      const shine = new THREE.PointLight("#ffe7b8", 6 * lamp.bright, 9, 1.5);
      bulb.position.set(lamp.x, lamp.y, z);
      shine.position.copy(bulb.position);
      this.lamps.add(bulb, shine);
    }
  }

  /** The floor as seen by a heat sensor, redrawn when a hot object has moved. */
  warm(look) {
    const objects = hotObjects(this.scene);
    const key = objects.map((each) => [each.x, each.y, each.heat].map((n) => n.toFixed(2))).join();
    if (key === this.warmed && this.floor.material.emissiveMap) return;
    this.warmed = key;
    const { data, columns, rows } = heatPicture(this.scene, maxHeat(this.scene));
    const picture = new THREE.DataTexture(data, columns, rows);
    picture.colorSpace = THREE.SRGBColorSpace;
    picture.magFilter = THREE.LinearFilter;
    picture.needsUpdate = true;
    this.floor.material.emissiveMap?.dispose();
    this.floor.material.emissiveMap = picture;
    this.floor.material.needsUpdate = true;
    for (const [, { meshes }] of this.groups) for (const mesh of meshes) mesh.material.emissive.set(look.heat(0));
  }

  /** The meshes of the robots of a kind, with room for a number of them. */
  group(kind, radius, count, detail) {
    let group = this.groups.get(kind);
    if (group && group.room >= count && group.detail === detail) return group;
    for (const mesh of group?.meshes ?? []) {
      this.world.remove(mesh);
      mesh.dispose();
    }
    const room = Math.max(8, count);
    const { painted, plain, top } = robotShape(kind, radius, detail === "near");
    const meshes = [painted, plain, top].map((geometry) => {
      const mesh = new THREE.InstancedMesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true }), room);
      mesh.frustumCulled = false;
      mesh.castShadow = detail === "near";
      mesh.receiveShadow = true;
      this.world.add(mesh);
      return mesh;
    });
    group = { meshes, room, detail, count: 0 };
    this.groups.set(kind, group);
    return group;
  }

  placeRobots(look, camera, width, height) {
    const { bodies } = this.scene;
    const isDots = bodies.length > DOTS && this.pixels(camera.distance) * 0.2 < LEAST_PIXELS;
    this.placeDots(isDots ? bodies : [], look);
    const byKind = new Map();
    for (const body of isDots ? [] : bodies) {
      const list = byKind.get(body.kind);
      if (list) list.push(body);
      else byKind.set(body.kind, [body]);
    }
    for (const [kind, group] of this.groups) if (!byKind.has(kind)) for (const mesh of group.meshes) mesh.count = 0;
    const place = new THREE.Object3D();
    const cold = look.heat?.(0);
    const detail = bodies.length > (this.isSoft ? NEAR_SOFT : NEAR_ROBOTS) ? "far" : "near";
    for (const [kind, list] of byKind) {
      const { meshes } = this.group(kind, list[0].radius, list.length, detail);
      const [painted, plain, top] = meshes;
      list.forEach((body, number) => {
        place.position.set(body.x, body.y, body.z);
        turned(place, body.base, body.slope);
        painted.setMatrixAt(number, place.matrix);
        plain.setMatrixAt(number, place.matrix);
        const front = body.turret ?? body.heading;
        if (front !== body.base) turned(place, front, body.slope);
        top.setMatrixAt(number, place.matrix);
        painted.setColorAt(number, colourOf(cold ?? body.colour));
      });
      for (const mesh of meshes) {
        mesh.count = list.length;
        mesh.instanceMatrix.needsUpdate = true;
        if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
      }
    }
  }

  /** Robots that are smaller than a few pixels, as points. */
  placeDots(bodies, look) {
    if (!this.dots && !bodies.length) return;
    if (!this.dots || this.dots.room < bodies.length) {
      if (this.dots) this.world.remove(this.dots.points);
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(bodies.length * 3), 3));
      geometry.setAttribute("color", new THREE.BufferAttribute(new Float32Array(bodies.length * 3), 3));
      const material = new THREE.PointsMaterial({ size: LEAST_PIXELS + 1, sizeAttenuation: false, vertexColors: true });
      const points = new THREE.Points(geometry, material);
      points.frustumCulled = false;
      this.world.add(points);
      this.dots = { points, room: bodies.length };
    }
    const { position, color } = this.dots.points.geometry.attributes;
    const cold = look.heat?.(0);
    bodies.forEach((body, number) => {
      const { r, g, b } = colourOf(cold ?? body.colour);
      position.setXYZ(number, body.x, body.y, body.z + body.height);
      color.setXYZ(number, r, g, b);
    });
    this.dots.points.geometry.setDrawRange(0, bodies.length);
    position.needsUpdate = color.needsUpdate = true;
  }

  /** The place on the floor, or at a height, under a point of the view. */
  ground(px, py, _camera, width, height, level = 0) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2((px / width) * 2 - 1, 1 - (py / height) * 2), this.lens);
    const at = ray.ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1), -level), new THREE.Vector3());
    return at ? [at.x, at.y] : null;
  }

  /** What is under a point of the view: the id of a shape or a robot, and where it is hit; null for the ground. */
  object(px, py, width, height) {
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2((px / width) * 2 - 1, 1 - (py / height) * 2), this.lens);
    const shapes = new Map([...this.meshes].map(([shape, mesh]) => [mesh, shape]));
    const robots = [...this.groups].flatMap(([kind, { meshes }]) => meshes.map((mesh) => [mesh, this.scene.bodies.filter((body) => body.kind === kind)]));
    const bodies = new Map(/** @type {[any, any][]} */ (robots));
    for (const mesh of bodies.keys()) mesh.computeBoundingSphere(); // robots have moved since
    const [hit] = ray.intersectObjects([...shapes.keys(), ...bodies.keys()], false);
    if (!hit) return null;
    const { id } = shapes.get(hit.object) ?? bodies.get(hit.object)[hit.instanceId];
    return { id, place: [hit.point.x, hit.point.y], height: hit.point.z };
  }

  dispose() {
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }
}

/** @type {Map<string, any>} */
const COLOURS = new Map();

/** A colour by its text: read once, as thousands of robots have the same few. @param {string} text */
function colourOf(text) {
  const found = COLOURS.get(text) ?? new THREE.Color(text);
  COLOURS.set(text, found);
  return found;
}

const UP = new THREE.Vector3(0, 0, 1);
const NORMAL = new THREE.Vector3();
const TILT = new THREE.Quaternion();

/** Turn something to a heading, on ground that is as steep as this along x and y. */
function turned(place, heading, slope) {
  place.quaternion.setFromAxisAngle(UP, heading);
  if (slope) place.quaternion.premultiply(TILT.setFromUnitVectors(UP, NORMAL.set(-slope[0], -slope[1], 1).normalize()));
  place.updateMatrix();
}

/** @type {boolean | null} */
let isSoft = null;

/** Whether WebGL is done by the processor: then shadows, smooth edges and small parts are left out. */
function isSoftware() {
  if (isSoft === null) {
    const gl = document.createElement("canvas").getContext("webgl2");
    const info = gl?.getExtension("WEBGL_debug_renderer_info");
    isSoft = /swiftshader|llvmpipe|software/i.test(info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "");
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
  }
  return isSoft;
}
