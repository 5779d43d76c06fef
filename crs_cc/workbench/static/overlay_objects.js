/** Overlay of a view: the outlines of movable objects. */
import { cornersOf } from "crs/scene.js";

const MAX = 500;

/** The tops of what robots can push, dashed. */
export function movable(o) {
  const { pen, scene } = o;
  pen.strokeStyle = o.look.colours.accent;
  pen.lineWidth = 1.5;
  pen.setLineDash([4, 3]);
  for (const shape of scene.shapes.filter((each) => each.movable).slice(0, MAX)) {
    const z = scene.ground.height(shape.x, shape.y) + (shape.lift ?? 0) + shape.height;
    pen.beginPath();
    if (shape.radius) o.circle(shape.x, shape.y, z, shape.radius);
    else {
      const corners = cornersOf(shape).map(([x, y]) => [x, y, z]);
      o.path([...corners, corners[0]]);
    }
    pen.stroke();
  }
  pen.setLineDash([]);
}
