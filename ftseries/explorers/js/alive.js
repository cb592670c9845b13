// Three bodies on the eight, which lies here: (x, y) is drawn at (-y, x). See alive.py.

import { mount } from "./view.js";
import { drawBody, drawTrail } from "./figure_eight_scene.js";
import { Eight, bodiesOf } from "./eight.js";

const SPEED = 1; // units of t in a second
const REACH = [1.25, 0.5];

const lying = ([x, y]) => [-y, x];

function build(stage) {
  const eight = new Eight(stage.series("r"), stage.series("phi"));
  const order = stage.stored;
  const plot = stage.plot({
    label: "Three equal bodies chase one another along an eight",
    x: { range: [-REACH[0], REACH[0]] },
    y: { range: [-REACH[1], REACH[1]] },
    aspect: REACH[1] / REACH[0],
    equal: true,
    frame: false,
  });
  const upright = eight.set(stage.get("lam"), order).motion().orbit;
  const orbit = { x: upright.y.map((y) => -y), y: upright.x };
  let time = 0.6;
  stage.say("One orbit for three bodies, a third of a period apart");
  stage.playUntilTouched();

  return {
    step(seconds) {
      time = (time + SPEED * seconds) % (2 * Math.PI);
    },

    draw() {
      plot.begin();
      plot.line(orbit.x, orbit.y, { color: "muted", width: 1.2, alpha: 0.5 });
      const bodies = bodiesOf(eight.set(stage.get("lam"), order).relatives(time)).map(lying);
      for (let body = 0; body < 3; body++) drawTrail(plot, { orbit, time }, body, 1);
      bodies.forEach(([x, y], body) => {
        drawBody(plot.context, plot.theme, [plot.px(x), plot.py(y)], body, 1);
      });
    },
  };
}

export default { render: (context) => mount(context, build) };
