// Runs the scripts of a model on a document that records frames. Standard input has the script, the
// data, whether there is WebGL, and events as JSON; what is shown at first and after each event is
// written.
const fs = require("node:fs");
const { script, data, webgl, events } = JSON.parse(fs.readFileSync(0, "utf8"));

/** The number of vertices and indices of each call that draws. */
let drawn = [];
const gl = new Proxy({}, {
  get: (_, name) => (...values) => {
    if (name === "drawElements") drawn.push(values[1]);
    if (name === "getParameter") return 1024;
    return {};
  },
});

class Node {
  constructor(content = "") {
    this.textContent = content;
    this.listeners = {};
    this.clientWidth = 640;
    this.clientHeight = 480;
  }
  addEventListener(name, listener) {
    (this.listeners[name] ??= []).push(listener);
  }
  setAttribute() {}
  setPointerCapture() {}
  getBoundingClientRect() {
    return { left: 0, top: 0, width: 640, height: 480 };
  }
  getContext() {
    return webgl ? gl : null;
  }
  send(name, event) {
    (this.listeners[name] ?? []).forEach((listener) => listener(event));
  }
}

const nodes = { script: new Node(data), button: new Node("Play") };
for (const name of [".stage", ".absent", ".help", ".controls", "[type=range]", "output"]) {
  nodes[name] = new Node();
}
nodes[".stage"].hidden = true;
const part = new Node();
part.querySelector = (selector) => nodes[selector];
const windowNode = new Node();
const paintings = [];
const page = {
  document: { querySelectorAll: () => [part] },
  window: { devicePixelRatio: 1 },
  getComputedStyle: () => ({ getPropertyValue: () => "#123456" }),
  requestAnimationFrame: (action) => paintings.push(action),
  ResizeObserver: class {
    observe() {}
  },
  addEventListener: (name, listener) => windowNode.addEventListener(name, listener),
  Image: class {
    async decode() {
      throw new Error("no picture");
    }
  },
};
new Function(...Object.keys(page), script)(...Object.values(page));

let time = 0;
const settle = async () => {
  for (let k = 0; k < 2; k++) {
    await new Promise((done) => setImmediate(done));
    paintings.splice(0).forEach((action) => action(time));
  }
};
const shown = () => {
  const answer = {
    output: nodes.output.textContent,
    button: nodes.button.textContent,
    absent: nodes[".absent"].hidden === true,
    stage: nodes[".stage"].hidden === false,
    drawn,
  };
  drawn = [];
  return answer;
};

(async () => {
  windowNode.send("DOMContentLoaded");
  await settle();
  const answers = [shown()];
  for (const { target, name, event, value, time: now } of events) {
    if (now !== undefined) time = now;
    const node = target === "part" ? part : nodes[target];
    if (value !== undefined) node.value = String(value);
    node?.send(name, { preventDefault() {}, target: node, ...event });
    await settle();
    answers.push(shown());
  }
  process.stdout.write(JSON.stringify(answers));
})();
