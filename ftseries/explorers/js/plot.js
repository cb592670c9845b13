// One set of axes on a canvas, in the colours of the page's theme.
//
//   const plot = stage.plot({             (see view.js; made by `new Plot(parent, theme, options)`)
//     label: "what the picture shows",    its text for screen readers: plot.describe(text) changes it
//     title: "Potential",                 heading above the axes (optional)
//     x: { label: "x", range: [0, 1] },   also: ticks: [values], format: (value) => text
//     y: { label: "V", range: [0, 1] },   log: true  for a logarithmic axis (range in plain values)
//     aspect: 0.62,                       height / width;  equal: true  gives both axes one scale
//     frame: true,                        false: no axes, only the picture
//     legend: [["series", "a label"], …]  a style name and its label, shown below as HTML
//   });
//   plot.x.range = […];                   ranges may change before begin()
//   plot.begin();                         clears, draws grid, axes, labels; then, in data units:
//   plot.line(xs, ys, style)              a curve; NaN breaks it
//   plot.dot(x, y, style, radius = 5)     plot.text(x, y, "text", style, { align, dx, dy })
//   plot.across(y, style)                 a horizontal line;  plot.down(x, style)  a vertical one
//   plot.arrow(x0, y0, x1, y1, style)     plot.band(x0, x1, style)  a shaded interval of x
//   plot.fill(xs, lower, upper, style)    the area between two curves
//   plot.image(pixels, columns, rows)     RGBA bytes, first row at the bottom, over the whole area
//   plot.px(x), plot.py(y)                data to CSS pixels;  plot.context  is the 2d context
//   plot.onPoint((x, y) => …)             taps, clicks and drags, in data units
//
// A style is a name of STYLES, or { color, width, dash, alpha } where color is "ink", "c1" … "c7"
// (Okabe and Ito's colours, chosen for the theme in explorers.css) or any CSS colour; "ground" is a
// colour to see it on in the legend. Curves that are compared differ in dash and width as well.

import { scaled, ticks, unscaled } from "./axes.js";

export const STYLES = {
  ink: { color: "ink", width: 1.2 },
  faint: { color: "faint", width: 1.2 },
  guide: { color: "muted", width: 1, dash: [2, 4] },
  exact: { color: "ink", width: 7, alpha: 0.26 },
  series: { color: "c1", width: 2 },
  error: { color: "c2", width: 1.8 },
  point: { color: "c2", width: 2 },
  second: { color: "c3", width: 1.8, dash: [7, 4] },
  limit: { color: "c4", width: 1.8, dash: [7, 4] },
};

/** The explorer's colours, read once from explorers.css and again when the theme changes. */
export class Theme {
  constructor(root) {
    this.root = root;
    this.refresh();
  }

  refresh() {
    const style = getComputedStyle(this.root);
    this.family = style.fontFamily;
    this.colors = {};
    for (const name of ["ink", "muted", "faint", "grid", "paper", "c1", "c2", "c3", "c4", "c5", "c6", "c7"]) {
      this.colors[name] = style.getPropertyValue(`--ft-${name}`).trim();
    }
  }

  color(name) {
    return this.colors[name] ?? name;
  }
}

export class Plot {
  constructor(parent, theme, { label, title, x, y, aspect = 0.62, equal = false, frame = true, legend = [] }) {
    Object.assign(this, { theme, x: { ...x }, y: { ...y }, aspect, equal, frame });
    this.figure = parent.appendChild(document.createElement("figure"));
    this.figure.className = "ft-plot";
    if (title) this.figure.appendChild(element("figcaption", "ft-title", title));
    this.canvas = this.figure.appendChild(document.createElement("canvas"));
    this.canvas.setAttribute("role", "img");
    this.context = this.canvas.getContext("2d");
    this.describe(label);
    if (legend.length) this.figure.appendChild(legendList(legend));
  }

  describe(label) {
    if (label !== this.label) this.canvas.setAttribute("aria-label", (this.label = label));
  }

  onPoint(use) {
    let down = false;
    const point = (event) => {
      const box = this.canvas.getBoundingClientRect();
      const clamp = (u) => Math.min(1, Math.max(0, u));
      const u = clamp((event.clientX - box.left - this.left) / (this.right - this.left));
      const v = clamp((event.clientY - box.top - this.bottom) / (this.top - this.bottom));
      use(unscaled(this.x, u), unscaled(this.y, v));
    };
    this.canvas.classList.add("ft-pointable");
    this.canvas.addEventListener("pointerdown", (event) => {
      down = true;
      if (event.pointerType === "mouse") this.canvas.setPointerCapture(event.pointerId);
      point(event);
    });
    this.canvas.addEventListener("pointermove", (event) => down && point(event));
    for (const end of ["pointerup", "pointercancel"]) {
      this.canvas.addEventListener(end, () => (down = false));
    }
  }

  /** Fit the canvas to its place; the browser's zoom and the screen decide about its pixels. */
  begin() {
    const { context, canvas } = this;
    const ratio = window.devicePixelRatio || 1;
    const width = Math.max(120, Math.round(this.figure.clientWidth));
    const height = Math.round(width * this.aspect);
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
      canvas.style.height = `${height}px`;
    }
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.lineJoin = context.lineCap = "round";
    this.context.font = `12px ${this.theme.family}`;
    if (this.frame) this.#axes(width, height);
    else this.#area(2, width - 2, height - 2, 2);
    return this;
  }

  #area(left, right, bottom, top) {
    if (this.equal) {
      const scale = Math.min(
        (right - left) / (this.x.range[1] - this.x.range[0]),
        (bottom - top) / (this.y.range[1] - this.y.range[0]),
      );
      const spareX = right - left - scale * (this.x.range[1] - this.x.range[0]);
      const spareY = bottom - top - scale * (this.y.range[1] - this.y.range[0]);
      [left, right, bottom, top] = [left + spareX / 2, right - spareX / 2, bottom - spareY / 2, top + spareY / 2];
    }
    Object.assign(this, { left, right, bottom, top });
  }

  #axes(width, height) {
    const { context, theme } = this;
    const yTicks = ticks(this.y, Math.max(3, Math.round(height / 45)));
    const widest = Math.max(...yTicks.map(({ text }) => context.measureText(text).width), 8);
    this.#area(widest + 10, width - 10, height - 36, this.y.label ? 22 : 8);
    const xTicks = ticks(this.x, Math.max(2, Math.round((this.right - this.left) / 70)));
    context.lineWidth = 1;
    context.strokeStyle = theme.color("grid");
    context.fillStyle = theme.color("muted");
    context.beginPath();
    for (const { value } of xTicks) this.#segment(this.px(value), this.top, this.px(value), this.bottom);
    for (const { value } of yTicks) this.#segment(this.left, this.py(value), this.right, this.py(value));
    context.stroke();
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const { value, text } of xTicks) context.fillText(text, this.px(value), this.bottom + 5);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const { value, text } of yTicks) context.fillText(text, this.left - 6, this.py(value));
    context.fillStyle = theme.color("ink");
    context.textBaseline = "alphabetic";
    if (this.x.label) context.fillText(this.x.label, this.right, height - 4);
    context.textAlign = "left";
    if (this.y.label) context.fillText(this.y.label, 2, 13);
    context.strokeStyle = theme.color("faint");
    context.strokeRect(this.left, this.top, this.right - this.left, this.bottom - this.top);
  }

  #segment(x0, y0, x1, y1) {
    this.context.moveTo(Math.round(x0) + 0.5, Math.round(y0) + 0.5);
    this.context.lineTo(Math.round(x1) + 0.5, Math.round(y1) + 0.5);
  }

  px(x) {
    return this.left + scaled(this.x, x) * (this.right - this.left);
  }

  py(y) {
    return this.bottom - scaled(this.y, y) * (this.bottom - this.top);
  }

  /** Draw with a style, inside the axes only. */
  #with(style, draw) {
    const { context } = this;
    const { color, width = 1.5, dash = [], alpha = 1 } = typeof style === "string" ? STYLES[style] : style;
    context.save();
    context.beginPath();
    context.rect(this.left - 1, this.top - 1, this.right - this.left + 2, this.bottom - this.top + 2);
    context.clip();
    context.strokeStyle = context.fillStyle = this.theme.color(color);
    context.lineWidth = width;
    context.globalAlpha = alpha;
    context.setLineDash(dash);
    context.beginPath();
    draw(context);
    context.restore();
  }

  line(xs, ys, style) {
    const far = 4 * (this.bottom - this.top); // far outside: canvases dislike 1e300
    this.#with(style, (context) => {
      let pen = false;
      for (let i = 0; i < xs.length; i++) {
        let y = this.py(ys[i]);
        if (Number.isNaN(y)) {
          pen = false;
          continue;
        }
        y = Math.min(this.bottom + far, Math.max(this.top - far, y));
        if (pen) context.lineTo(this.px(xs[i]), y);
        else context.moveTo(this.px(xs[i]), y);
        pen = true;
      }
      context.stroke();
    });
  }

  dot(x, y, style, radius = 5) {
    this.#with(style, (context) => {
      context.arc(this.px(x), this.py(y), radius, 0, 2 * Math.PI);
      context.setLineDash([]);
      context.fill();
      context.strokeStyle = this.theme.color("paper");
      context.lineWidth = 1.5;
      context.stroke();
    });
  }

  across(y, style) {
    this.line(this.x.range, [y, y], style);
  }

  down(x, style) {
    this.line([x, x], this.y.range, style);
  }

  fill(xs, lower, upper, style) {
    this.#with(style, (context) => {
      xs.forEach((x, i) => context.lineTo(this.px(x), this.py(lower[i])));
      for (let i = xs.length - 1; i >= 0; i--) context.lineTo(this.px(xs[i]), this.py(upper[i]));
      context.fill();
    });
  }

  band(x0, x1, style) {
    this.#with(style, (context) => {
      context.fillRect(this.px(x0), this.top, this.px(x1) - this.px(x0), this.bottom - this.top);
    });
  }

  arrow(x0, y0, x1, y1, style, head = 9) {
    const [ax, ay, bx, by] = [this.px(x0), this.py(y0), this.px(x1), this.py(y1)];
    const length = Math.hypot(bx - ax, by - ay);
    if (!(length > 1e-9)) return;
    const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
    const size = Math.min(head, length);
    this.#with(style, (context) => {
      context.moveTo(ax, ay);
      context.lineTo(bx - 0.8 * size * ux, by - 0.8 * size * uy);
      context.stroke();
      context.setLineDash([]);
      context.beginPath();
      context.moveTo(bx, by);
      context.lineTo(bx - size * ux - 0.45 * size * uy, by - size * uy + 0.45 * size * ux);
      context.lineTo(bx - size * ux + 0.45 * size * uy, by - size * uy - 0.45 * size * ux);
      context.fill();
    });
  }

  text(x, y, text, style = "ink", { align = "left", dx = 0, dy = 0, size = 12 } = {}) {
    this.#with(style, (context) => {
      context.font = `${size}px ${this.theme.family}`;
      context.textAlign = align;
      context.textBaseline = "middle";
      context.fillText(text, this.px(x) + dx, this.py(y) + dy);
    });
  }

  image(pixels, columns, rows) {
    const picture = new OffscreenCanvas(columns, rows);
    picture.getContext("2d").putImageData(new ImageData(pixels, columns, rows), 0, 0);
    this.#with("ink", (context) => {
      context.translate(this.left, this.bottom);
      context.scale((this.right - this.left) / columns, -(this.bottom - this.top) / rows);
      context.imageSmoothingEnabled = true;
      context.drawImage(picture, 0, 0);
    });
  }
}

export function element(tag, className, text) {
  const node = document.createElement(tag);
  node.className = className;
  if (text !== undefined) node.textContent = text;
  return node;
}

function legendList(entries) {
  const list = element("ul", "ft-legend");
  for (const [name, label] of entries) {
    const item = list.appendChild(element("li", ""));
    const style = typeof name === "string" ? STYLES[name] : name;
    const { color, width = 1.5, dash = [], alpha = 1, ground = "none" } = style;
    const paint = /^[a-z]+\d?$/.test(color) ? `var(--ft-${color})` : color;
    item.innerHTML =
      `<svg width="26" height="10" style="background:${ground}" aria-hidden="true">` +
      `<line x1="1" y1="5" x2="25" y2="5" ` +
      `style="stroke:${paint};stroke-width:${width};stroke-dasharray:${dash};opacity:${alpha}"/></svg>`;
    item.append(label);
  }
  return list;
}
