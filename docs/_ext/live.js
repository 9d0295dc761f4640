import * as charts from "dualcay/charts.js";

const home = document.getElementById("live"), form = home.querySelector("form"), picture = home.querySelector("svg");
const read = name => Number(form.elements[name].value);
const show = (name, text) => { home.querySelector(`[data-shown=${name}]`).textContent = text; };
const digits = (x, count = 3) => (Number.isFinite(x) ? x.toFixed(count).replace(/^-(?=[0.]+$)/, "") : `${x}`);
const listed = numbers => {
  const texts = Array.from(numbers, x => digits(x));
  return `(${texts.slice(0, 3).join(", ")}) + ε (${texts.slice(3).join(", ")})`;
};
const RADIANS = Math.PI / 180, SIZES = [0.9, 0.6, 0.3];
const CORNERS = [0, 1, 2, 3, 4, 5, 6, 7].map(k => SIZES.map((size, place) => ((k >> place) & 1 ? size : -size)));
const EDGES = CORNERS.flatMap((_, k) => [1, 2, 4].filter(bit => !(k & bit)).map(bit => [CORNERS[k], CORNERS[k | bit]]));
const COLOURS = ["#d62728", "#2ca02c", "#1f77b4"];

// Place of a point on the picture, seen from above along (1, 1, 0).
const seen = ([x, y, z]) => `${(0.7 * (y - x)).toFixed(3)} ${(0.35 * (x + y) - 0.87 * z).toFixed(3)}`;
const moved = (pose, [x, y, z]) => [0, 4, 8].map(at => pose[at] * x + pose[at + 1] * y + pose[at + 2] * z + pose[at + 3]);
const path = (lines, style) => `<path d="${lines.map(([a, b]) => `M${seen(a)}L${seen(b)}`).join("")}" fill="none" ${style}/>`;

const draw = (pose, u) => {
  const far = u.map(x => 1.7 * x), still = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
  const box = (at, style) => path(EDGES.map(edge => edge.map(point => moved(at, point))), style);
  const arrows = [0, 1, 2].map(k => {
    const end = [0, 0, 0];
    end[k] = 1.2;
    return path([[moved(pose, [0, 0, 0]), moved(pose, end)]], `stroke="${COLOURS[k]}" stroke-width="0.04"`);
  });
  picture.innerHTML = [
    box(still, 'stroke="currentColor" stroke-width="0.01" opacity="0.4"'),
    path([[far.map(x => -x), far]], 'stroke="currentColor" stroke-width="0.015" stroke-dasharray="0.06"'),
    ...(pose.every(Number.isFinite) ? [box(pose, 'stroke="currentColor" stroke-width="0.03"'), ...arrows] : []),
  ].join("");
};

const update = () => {
  const chart = charts[form.elements.chart.value], turn = read("turn") * RADIANS, shift = read("shift");
  const azimuth = read("azimuth") * RADIANS, height = read("height") * RADIANS;
  const u = [Math.cos(height) * Math.cos(azimuth), Math.cos(height) * Math.sin(azimuth), Math.sin(height)];
  const v = chart.from_exponential([...u.map(x => turn * x), ...u.map(x => shift * x)]);
  const across = [-Math.sin(azimuth), Math.cos(azimuth), 0], T = chart.tangent(v), [alpha, along] = chart.angle(v);
  const stretch = w => Math.hypot(...[0, 3, 6].map(at => T[at] * w[0] + T[at + 1] * w[1] + T[at + 2] * w[2]));
  const [one, other] = [stretch(u), stretch(across)];
  for (const name of ["turn", "azimuth", "height"]) form.elements[`${name}_shown`].value = `${digits(read(name), 0)}`;
  form.elements.shift_shown.value = digits(shift, 2);
  show("v", listed(v));
  show("angle", `${digits(alpha / RADIANS, 1)}°, shift ${digits(along, 2)}`);
  show("shadow", listed(chart.shadow(v, 1)));
  show("condition", digits(Math.max(one, other) / Math.min(one, other), 2));
  draw(chart.pose(v), u);
};
form.addEventListener("input", update);
form.addEventListener("submit", event => event.preventDefault());
update();
