// The life of an explorer's view: from the model's traits to a picture, at most once a frame.
//
//   import { mount } from "./view.js";
//   export default { render: (context) => mount(context, build) };
//
//   function build(stage) {
//     const x = stage.series("x");               a Series of series.js, from the trait `data`
//     const plot = stage.plot({…});              see plot.js; plots stand side by side if there is room
//     return {
//       draw() {                                 called after any change of a trait, size or theme
//         const order = stage.order();           the trait, never beyond what is stored; else says so
//         const lam = stage.number("lam", 0, 3); the trait, clamped to the range; else says so
//         …
//         stage.say(`order ${order}, λ = ${lam.toFixed(2)}, …`);   the state as text, announced
//         stage.show([["ω", 3.4458763864722], …]);                 numbers with their names, 13 digits
//       },
//       step(seconds) { … },                     optional: called every frame while the trait `playing`
//     };                                         is true and the view is on the screen
//   }
//
// Further: stage.get(trait), stage.set(trait, value) (linked controls follow), stage.redraw(),
// stage.note(text) (a hint for this drawing only), stage.root, stage.panels (the grid of plots),
// stage.reducedMotion(), stage.onRemove(function). stage.playUntilTouched() in build starts the motion,
// which ends when the reader takes a slider or a picture (the button named Play brings it back);
// readers who prefer reduced motion start it themselves. A toggle button linked to a trait is an ordinary
// button if the view sets the trait back to false in draw().
//
// `throw new Complaint("One sentence.")` in build or draw puts the sentence in the explorer's place;
// nothing else on the page is touched.

import { Complaint, Series } from "./series.js";
import { Plot, Theme, element } from "./plot.js";

export function mount({ model, el }, build) {
  const stage = new Stage(model, el);
  stage.start(build);
  const restart = () => stage.start(build);
  model.on("change:data", restart);
  return () => {
    model.off("change:data", restart);
    stage.remove();
  };
}

class Stage {
  constructor(model, el) {
    this.model = model;
    this.root = el.appendChild(element("div", "ft-view"));
    this.theme = new Theme(this.root);
    this.cleanup = [];
    this.notes = [];
    this.redraw = this.redraw.bind(this);
    model.on("change", this.redraw);
    this.onRemove(() => model.off("change", this.redraw));
    const sizes = new ResizeObserver(this.redraw);
    sizes.observe(this.root);
    this.onRemove(() => sizes.disconnect());
    this.#followTheme();
    this.#followScreen();
    requestAnimationFrame(() => this.#dress());
  }

  start(build) {
    this.root.replaceChildren();
    this.complaint = undefined;
    this.notice = this.root.appendChild(element("p", "ft-note"));
    this.panels = this.root.appendChild(element("div", "ft-panels"));
    this.status = this.root.appendChild(element("p", "ft-status"));
    this.status.setAttribute("role", "status");
    this.table = this.root.appendChild(element("dl", "ft-readings"));
    this.#guard(() => (this.scene = build(this)));
    this.redraw();
  }

  remove() {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.later);
    for (const action of this.cleanup) action();
    this.root.remove();
  }

  onRemove(action) {
    this.cleanup.push(action);
  }

  get(trait) {
    return this.model.get(trait);
  }

  set(trait, value) {
    if (this.get(trait) === value) return;
    this.model.set(trait, value);
    this.model.save_changes();
  }

  series(name) {
    const series = new Series(this.get("data")?.[name], name);
    this.stored = Math.min(this.stored ?? Infinity, series.order);
    return series;
  }

  plot(options) {
    return new Plot(this.panels, this.theme, options);
  }

  order(trait = "order") {
    const order = this.get(trait);
    if (order > this.stored) this.note(`Order ${order} is not stored; order ${this.stored} is shown.`);
    return Math.max(0, Math.min(order, this.stored));
  }

  number(trait, low, high, name = trait === "lam" ? "λ" : trait) {
    const value = this.get(trait);
    const inside = clamped(value, low, high);
    if (inside !== value) this.note(outside(name, value, low, high));
    return inside;
  }

  note(text) {
    this.notes.push(text);
  }

  say(text) {
    this.saying = text;
    this.later ??= setTimeout(() => {
      this.later = undefined;
      this.status.textContent = this.saying;
    }, 100);
  }

  /** Rows [name, number or text]: numbers with 13 significant digits. */
  show(rows) {
    while (this.table.children.length < rows.length) {
      const pair = this.table.appendChild(document.createElement("div"));
      pair.append(document.createElement("dt"), document.createElement("dd"));
    }
    rows.forEach(([name, value], i) => {
      const [dt, dd] = this.table.children[i].children;
      const text = typeof value === "number" ? digits(value) : value;
      if (dt.textContent !== name) dt.textContent = name;
      if (dd.textContent !== text) dd.textContent = text;
    });
    while (this.table.children.length > rows.length) this.table.lastChild.remove();
  }

  reducedMotion() {
    return matchMedia("(prefers-reduced-motion: reduce)").matches;
  }

  playUntilTouched() {
    if (this.reducedMotion()) return;
    this.set("playing", true);
    requestAnimationFrame(() => {
      const box = this.root.closest(".ft-explorer") ?? this.root;
      const still = (event) => {
        if (event.target.closest("button") || event.key === "Tab") return;
        if (event.target.closest(".noUi-target, .widget-readout, .ft-cell, canvas")) this.set("playing", false);
      };
      for (const event of ["pointerdown", "keydown"]) {
        box.addEventListener(event, still, true);
        this.onRemove(() => box.removeEventListener(event, still, true));
      }
    });
  }

  redraw() {
    this.frame ??= requestAnimationFrame((now) => {
      this.frame = undefined;
      this.#frame(now);
    });
  }

  #frame(now) {
    if (this.complaint || !this.scene || !this.root.isConnected) return;
    const playing = this.scene.step && this.get("playing") && this.visible;
    keep(this.status, { "aria-live": playing ? "off" : "polite" }); // no talk of every frame
    this.#guard(() => {
      if (playing) this.scene.step(Math.min(0.1, (now - (this.last ?? now)) / 1000));
      this.notes = this.typed ? [this.typed] : [];
      this.scene.draw();
      const note = this.notes.join(" ");
      if (this.notice.textContent !== note) this.notice.textContent = note;
    });
    this.last = playing ? now : undefined;
    if (playing) this.redraw();
  }

  #guard(action) {
    try {
      action();
    } catch (error) {
      this.complaint = error;
      const text = error instanceof Complaint ? error.message : `It stopped with “${error.message}”.`;
      const place = element("p", "ft-error", `This explorer cannot be shown. ${text}`);
      place.setAttribute("role", "alert");
      this.root.replaceChildren(place);
      if (!(error instanceof Complaint)) console.error(error);
    }
  }

  #followTheme() {
    const follow = () => {
      this.theme.refresh();
      this.redraw();
    };
    const watch = new MutationObserver(follow);
    const attributeFilter = ["data-theme", "data-jp-theme-light", "data-jp-theme-name", "class"];
    watch.observe(document.documentElement, { attributes: true, attributeFilter });
    watch.observe(document.body, { attributes: true, attributeFilter });
    const system = matchMedia("(prefers-color-scheme: dark)");
    system.addEventListener("change", follow);
    this.onRemove(() => {
      watch.disconnect();
      system.removeEventListener("change", follow);
    });
    requestAnimationFrame(follow);
  }

  #followScreen() {
    const watch = new IntersectionObserver(([entry]) => {
      this.visible = entry.isIntersecting;
      this.redraw();
    });
    watch.observe(this.root);
    this.onRemove(() => watch.disconnect());
  }

  /** What ipywidgets' own controls lack: names for slider handles, the state of toggle buttons,
   *  and a word when a typed value cannot be taken as it is. */
  #dress() {
    const controls = this.root.closest(".ft-explorer")?.querySelector(".ft-controls");
    if (!controls) return;
    const dress = () => {
      for (const control of controls.querySelectorAll(".jupyter-widgets")) {
        const name = control.querySelector(".widget-label")?.textContent;
        const handle = control.querySelector(".noUi-handle");
        const readout = control.querySelector(".widget-readout");
        if (!name || !handle || !readout) continue;
        const value = readout.textContent;
        keep(handle, { "aria-label": name, "aria-valuetext": value, "aria-valuenow": plain(value) });
        keep(readout, { role: "textbox", "aria-label": `${name}, typed` });
      }
      for (const button of controls.querySelectorAll(".widget-toggle-button")) {
        const active = button.classList.contains("mod-active");
        const [shown, wanted] = [button.textContent, active ? "Pause" : "Play"];
        if (shown !== "Play" && shown !== "Pause") keep(button, { "aria-pressed": String(active) });
        else if (shown !== wanted) button.textContent = wanted;
        if (button.title === "Play") button.removeAttribute("title");
      }
    };
    dress();
    const watch = new MutationObserver(dress);
    watch.observe(controls, {
      subtree: true, childList: true, attributes: true, attributeFilter: ["class", "aria-valuetext"],
    });
    const typed = (event) => {
      if (event.type === "keydown" && event.key !== "Enter") return;
      if (event.target.classList?.contains("widget-readout")) this.#judge(event.target);
    };
    const forget = () => {
      this.typed = undefined;
      this.redraw();
    };
    const listeners = { keydown: typed, focusout: typed, focusin: forget, pointerdown: forget };
    for (const [event, listener] of Object.entries(listeners)) {
      controls.addEventListener(event, listener, true); // before ipywidgets takes the text
    }
    this.onRemove(() => {
      watch.disconnect();
      for (const [event, listener] of Object.entries(listeners)) {
        controls.removeEventListener(event, listener, true);
      }
    });
  }

  /** A sentence if a typed text is no number, or beyond the ends of its slider. */
  #judge(readout) {
    const slider = readout.parentElement.querySelector(".noUi-handle");
    const name = slider?.getAttribute("aria-label");
    const [text, value] = [readout.textContent, plain(readout.textContent)];
    const [low, high] = ["aria-valuemin", "aria-valuemax"].map((end) => Number(slider?.getAttribute(end)));
    if (Number.isNaN(value)) this.typed = `“${text}” is not a number; ${name} stays as it was.`;
    else if (value < low || value > high) this.typed = outside(name, value, low, high);
    this.redraw();
  }
}

function keep(node, attributes) {
  for (const [name, value] of Object.entries(attributes)) {
    if (node.getAttribute(name) !== String(value)) node.setAttribute(name, value);
  }
}

/** The number of a readout, whose minus sign is a typographic one. */
function plain(text) {
  return Number(text.replace("−", "-"));
}

function clamped(value, low, high) {
  return Number.isFinite(value) ? Math.min(high, Math.max(low, value)) : low;
}

function outside(name, value, low, high) {
  return `${name} = ${value} is outside ${low} … ${high}; ${clamped(value, low, high)} is shown.`;
}

function digits(value) {
  return Number.isFinite(value) ? value.toPrecision(13).replace("-", "−") : "not finite";
}
