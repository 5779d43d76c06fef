/** The world in three dimensions, by three.js. z points up. */
import * as THREE from "three";
import { OrbitCamera } from "crs/camera.js";

const ROBOT_HEIGHT = 0.35;
const NEAR_ROBOTS = 1000; // more are drawn without noses

export class View3D {
  /** @param {import("./scene.js").Scene} scene @param {HTMLCanvasElement} canvas */
  constructor(scene, canvas) {
    this.scene = scene;
    this.canvas = canvas;
    this.camera = new OrbitCamera(scene.area);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
    this.lens = new THREE.PerspectiveCamera(45, 1, 0.05, 5000);
    this.lens.up.set(0, 0, 1);
    this.world = new THREE.Scene();
    this.world.background = new THREE.Color("#dfe5ee");
    const sun = new THREE.DirectionalLight("#ffffff", 2.2);
    sun.position.set(-0.4, -0.7, 1);
    this.world.add(sun, new THREE.HemisphereLight("#ffffff", "#8d95a3", 1.4));
    this.addFloor();
    this.meshes = new Map(scene.shapes.map((shape) => [shape, this.addShape(shape)]));
    this.robots = null;
  }

  addFloor() {
    const { x, y, length, width } = this.scene.area;
    const floor = new THREE.Mesh(
      new THREE.PlaneGeometry(length, width),
      new THREE.MeshLambertMaterial({ color: "#f7f8fa" }),
    );
    floor.position.set(x + length / 2, y + width / 2, 0);
    this.world.add(floor);
  }

  addShape(shape) {
    let geometry;
    if (shape.radius) {
      geometry = new THREE.CylinderGeometry(shape.radius, shape.radius, shape.height, 32);
      geometry.rotateX(Math.PI / 2).translate(0, 0, shape.height / 2);
    } else {
      const outline = new THREE.Shape(shape.corners.map(([x, y]) => new THREE.Vector2(x, y)));
      geometry = new THREE.ExtrudeGeometry(outline, { depth: shape.height, bevelEnabled: false });
    }
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: shape.colour }));
    this.world.add(mesh);
    return mesh;
  }

  /** Make room for a number of robots: one instanced mesh of bodies, one of noses. */
  addRobots(count) {
    for (const mesh of this.robots ?? []) this.world.remove(mesh);
    const body = new THREE.CylinderGeometry(1, 1, ROBOT_HEIGHT, count > NEAR_ROBOTS ? 8 : 24);
    body.rotateX(Math.PI / 2).translate(0, 0, ROBOT_HEIGHT / 2);
    const nose = new THREE.BoxGeometry(0.7, 0.16, 0.04).translate(0.45, 0, ROBOT_HEIGHT + 0.02);
    this.robots = [body, ...(count > NEAR_ROBOTS ? [] : [nose])].map((geometry) => {
      const mesh = new THREE.InstancedMesh(geometry, new THREE.MeshLambertMaterial(), count);
      mesh.frustumCulled = false;
      this.world.add(mesh);
      return mesh;
    });
    this.capacity = count;
  }

  draw() {
    const { canvas, scene, renderer } = this;
    const [width, height] = [canvas.clientWidth, canvas.clientHeight];
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height, false);
    for (const [shape, mesh] of this.meshes) {
      mesh.position.set(shape.x, shape.y, 0);
      mesh.rotation.z = shape.angle;
    }
    this.placeRobots(scene.bodies);
    this.lens.aspect = width / height;
    this.lens.updateProjectionMatrix();
    this.lens.position.set(...this.camera.eye());
    this.lens.lookAt(this.camera.x, this.camera.y, 0);
    renderer.render(this.world, this.lens);
  }

  placeRobots(bodies) {
    if (!this.robots || bodies.length > this.capacity) this.addRobots(Math.max(1, bodies.length));
    const [place, paint] = [new THREE.Object3D(), new THREE.Color()];
    bodies.forEach((body, number) => {
      place.position.set(body.x, body.y, 0);
      place.rotation.z = body.heading;
      place.scale.set(body.radius, body.radius, 1);
      place.updateMatrix();
      this.robots.forEach((mesh, part) => {
        mesh.setMatrixAt(number, place.matrix);
        mesh.setColorAt(number, paint.set(part ? "#ffffff" : body.colour));
      });
    });
    for (const mesh of this.robots) {
      mesh.count = bodies.length;
      mesh.instanceMatrix.needsUpdate = true;
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }
}
