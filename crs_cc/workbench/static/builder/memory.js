/** What the page remembers while its session lasts, so that a run or a reload is no loss. */

const KEY = "crs-build";

/**
 * Remember what is hidden, locked and selected, the unit and the view. A server has an origin of
 * its own, and with it a memory of its own.
 * @param {import("./model.js").Model} model @param {import("./view.js").View} view
 */
export function remember(model, view) {
  addEventListener("pagehide", () => {
    const [hidden, locked, selection] = [model.hidden, model.locked, model.selection].map((names) => [...names]);
    const { chosenUnit, path } = model;
    sessionStorage.setItem(KEY, JSON.stringify({ hidden, locked, selection, chosenUnit, path, centre: view.centre, scale: view.scale }));
  });
}

/** Restore it; whether there was something. @param {import("./model.js").Model} model @param {import("./view.js").View} view */
export function recall(model, view) {
  const known = JSON.parse(sessionStorage.getItem(KEY) ?? "null");
  if (!known) return false;
  const { hidden, locked, selection, chosenUnit, path, centre, scale } = known;
  [model.hidden, model.locked] = [new Set(hidden), new Set(locked)];
  model.chosenUnit = chosenUnit;
  model.path = path;
  model.updateIndex();
  [view.centre, view.scale, view.isPlaced] = [centre, scale, true];
  model.select(selection.filter((name) => model.item(name)));
  view.renew();
  return true;
}
