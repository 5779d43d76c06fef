/** Round numbers for grids and scales. */

/** The least of 1, 2, 5 times a power of ten that is as large. @param {number} least */
export function gridStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((each) => each * power).find((each) => each >= least * 0.999) ?? 10 * power;
}

/** A length for people. @param {number} metres */
export const lengthText = (metres) => (metres < 1 ? `${+(metres * 100).toPrecision(3)} cm` : `${+metres.toPrecision(4)} m`);

/** Where something on a robot looks. @param {number} radians counter-clockwise from ahead */
export function sideText(radians) {
  const exact = (Math.atan2(Math.sin(radians), Math.cos(radians)) * 180) / Math.PI;
  const degrees = Math.sign(exact) * Math.round(Math.abs(exact) - 1e-6); // both sides alike
  if (!degrees) return "ahead";
  return Math.abs(degrees) === 180 ? "behind" : `${Math.abs(degrees)}° ${degrees > 0 ? "left" : "right"}`;
}

/** A direction for people. @param {number} radians */
export const angleText = (radians) => `${((Math.round((radians * 180) / Math.PI) % 360) + 360) % 360}°`;
