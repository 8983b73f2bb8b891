// Runs the script of a page on a document that records what is painted on its canvas. The script
// and the events to be sent stand as JSON on standard input; what is painted after each event is
// written as JSON.
const fs = require("node:fs");
const { script, scene, events } = JSON.parse(fs.readFileSync(0, "utf8"));

let calls = [];
const context = new Proxy(
  {},
  {
    get: (_, name) => (...values) => {
      if (name === "measureText") return { width: 9 * values[0].length };
      calls.push([name, ...values]);
      return { addColorStop() {} };
    },
    set: () => true,
  },
);

class Node {
  constructor(content) {
    this.textContent = content;
    this.style = {};
    this.attributes = {};
    this.children = [];
    this.listeners = {};
    this.clientWidth = 640;
    this.clientHeight = 480;
  }
  addEventListener(name, listener) {
    this.listeners[name] = listener;
  }
  append(...children) {
    this.children.push(...children);
  }
  setAttribute(name, value) {
    this.attributes[name] = value;
  }
  setPointerCapture() {}
  getContext() {
    return context;
  }
}

const nodes = {};
for (const id of ["stage", "legend", "still", "footer"]) nodes[id] = new Node("");
nodes.scene = new Node(scene);
const windowNode = new Node("");
const preference = new Node("");
const frames = [];
const page = {
  document: {
    getElementById: (id) => nodes[id],
    querySelector: (selector) => nodes[selector],
    createElement: () => new Node(""),
  },
  location: { hash: "" },
  window: { devicePixelRatio: 2 },
  getComputedStyle: () => ({ getPropertyValue: () => " #123456" }),
  requestAnimationFrame: (action) => frames.push(action),
  ResizeObserver: class {
    observe() {}
  },
  addEventListener: (name, listener) => windowNode.addEventListener(name, listener),
  matchMedia: () => preference,
};
new Function(...Object.keys(page), script)(...Object.values(page));

const painted = [calls];
for (const { target, name, event } of events) {
  calls = [];
  if ("hash" in event) page.location.hash = event.hash;
  const [id, index] = target.split(" ");
  const node = id === "window" ? windowNode : nodes[id];
  const receiver = index === undefined ? node : node.children[Number(index)].children[0];
  receiver.listeners[name]({ preventDefault() {}, ...event });
  frames.splice(0).forEach((action) => action());
  painted.push(calls);
}
process.stdout.write(
  JSON.stringify({
    painted,
    hidden: { still: nodes.still.hidden, stage: nodes.stage.hidden, legend: nodes.legend.hidden },
  }),
);
