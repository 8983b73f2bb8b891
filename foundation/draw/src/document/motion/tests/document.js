// Runs the scripts of a motion on a document that records what is painted. Standard input has the
// script, the data and events as JSON; what is shown at first and after each event is written.
const fs = require("node:fs");
const { script, data, events } = JSON.parse(fs.readFileSync(0, "utf8"));

/** Calls of the canvas since it was cleared. */
const painter = () => {
  const calls = [];
  const context = new Proxy({}, {
    get: (_, name) => (...values) => {
      if (name === "measureText") return { width: 9 * values[0].length };
      if (name === "clearRect") calls.length = 0;
      calls.push([name, ...values]);
      return undefined;
    },
    set: () => true,
  });
  return { calls, context };
};

class Node {
  constructor(content = "") {
    this.textContent = content;
    this.listeners = {};
    this.clientWidth = 640;
    this.clientHeight = 480;
    Object.assign(this, painter());
  }
  addEventListener(name, listener) {
    (this.listeners[name] ??= []).push(listener);
  }
  setAttribute() {}
  setPointerCapture() {}
  getBoundingClientRect() {
    return { left: 0, top: 0 };
  }
  getContext() {
    return this.context;
  }
  send(name, event) {
    (this.listeners[name] ?? []).forEach((listener) => listener(event));
  }
}

const films = [new Node(), new Node()];
const notes = [new Node(), new Node()];
const nodes = { script: new Node(data) };
for (const name of ["stage", "still", "views", "controls", "help"]) nodes[`.${name}`] = new Node();
for (const name of ["button", "[type=range]", "output", "[type=checkbox]"]) nodes[name] = new Node();
nodes.button.textContent = "Play";
const part = new Node();
part.querySelector = (selector) => nodes[selector];
part.querySelectorAll = (selector) => (selector.endsWith("canvas") ? films : notes);
const windowNode = new Node();
const paintings = [];
/** The end of the picture whose decoding waits for the event `release`. */
const held = events.find(({ hold }) => hold)?.hold ?? "none";
let setFree;
const release = new Promise((done) => (setFree = done));
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
      if (this.src.endsWith(held)) await release;
    }
  },
};
new Function(...Object.keys(page), script)(...Object.values(page));

let time = 0;
const settle = async () => {
  await new Promise((done) => setImmediate(done));
  paintings.splice(0).forEach((action) => action(time));
  await new Promise((done) => setImmediate(done));
};
const shown = () => {
  const calls = nodes[".stage"].calls;
  const arcs = calls.filter(([name]) => name === "arc");
  const images = films.map(({ calls }) => calls.filter(([name]) => name === "drawImage").pop());
  return {
    output: nodes.output.textContent,
    frame: Number(nodes["[type=range]"].value),
    button: nodes.button.textContent,
    lines: calls.filter(([name]) => name === "moveTo" || name === "lineTo"),
    points: arcs.length,
    heads: arcs.map(([, x, y]) => [x, y]),
    texts: calls.filter(([name]) => name === "fillText").map(([, text]) => text),
    pictures: images.map((image) => image?.[1].src.split(",")[1] ?? null),
    notes: notes.map(({ textContent }) => textContent),
    hidden: {
      still: nodes[".still"].hidden,
      views: nodes[".views"].hidden,
      controls: nodes[".controls"].hidden,
    },
  };
};

(async () => {
  windowNode.send("DOMContentLoaded");
  await settle();
  const answers = [shown()];
  for (const { target, name, event, value, time: now, release } of events) {
    if (now !== undefined) time = now;
    if (release) setFree();
    const node = target === "part" ? part : nodes[target] ?? nodes[`.${target}`];
    if (value !== undefined) node.value = String(value);
    if (name === "change") node.checked = !node.checked;
    node?.send(name, { preventDefault() {}, target: node, ...event });
    await settle();
    answers.push(shown());
  }
  process.stdout.write(JSON.stringify(answers));
})();
