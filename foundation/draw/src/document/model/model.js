/** Shows the models of the page, and follows the pointer, the keys and the slider. */
(() => {
  const { oncePerPainting, turntable } = stages;

  function start(part) {
    const find = (selector) => part.querySelector(selector);
    const stage = find(".stage");
    const data = JSON.parse(find("script").textContent);
    const model = mesh.decode(data);
    const front = { azimuth: data.azimuth, elevation: data.elevation, zoom: 1 };
    const view = { ...front, shift: [0, 0] };
    let frame = 0;
    /** The zoom for which `view.shift` holds, and the pointer on the canvas. */
    let [zoom, pointer] = [1, [0, 0]];
    let painter = null;

    const redraw = oncePerPainting(() => {
      view.shift = mesh.shifted(view.shift, pointer, view.zoom / zoom, view.zoom);
      zoom = view.zoom;
      const ink = getComputedStyle(stage).getPropertyValue("--floor").trim();
      painter?.paint(view, frame, ink);
    });
    /** Begins to draw, or does so again after the browser took the canvas from the page. */
    function begin() {
      painter = painters.makePainter(stage, data, model);
      if (painter && data.picture) {
        const image = new Image();
        image.src = data.picture;
        const mine = painter;
        // The model stays grey where the picture cannot be read.
        image.decode().then(() => mine === painter && painter.setPicture(image), () => {}).then(redraw);
      }
      redraw();
      return painter !== null;
    }
    if (!begin()) return;
    stage.addEventListener("webglcontextlost", (event) => {
      event.preventDefault();
      painter = null;
    });
    stage.addEventListener("webglcontextrestored", begin);
    /** The fingers on the canvas, in the middle of which two of them zoom. */
    const fingers = new Map();
    for (const name of ["pointerdown", "pointermove", "wheel"]) {
      stage.addEventListener(name, (event) => {
        const { left, top, width, height } = stage.getBoundingClientRect();
        const [x, y] = [event.clientX - left, event.clientY - top];
        const at = [(2 * x) / width - 1, 1 - (2 * y) / height];
        if (name === "pointerdown" || fingers.has(event.pointerId)) fingers.set(event.pointerId, at);
        const all = fingers.size ? [...fingers.values()] : [at];
        pointer = [0, 1].map((k) => all.reduce((sum, place) => sum + place[k], 0) / all.length);
      }, { passive: true });
    }
    for (const name of ["pointerup", "pointercancel"]) {
      stage.addEventListener(name, (event) => fingers.delete(event.pointerId));
    }
    // Keys zoom into the middle.
    stage.addEventListener("keydown", () => (pointer = [0, 0]));
    turntable(stage, view, front, redraw);
    find(".absent").hidden = true;
    stage.hidden = false;
    find(".help").hidden = false;
    if (data.frames > 1) {
      player(part, data, (shown) => {
        frame = shown;
        redraw();
      });
    }
    new ResizeObserver(redraw).observe(stage);
  }

  /** The button, the slider and the keys of a part, which call `show` with each frame. */
  function player(part, data, show) {
    const [controls, button, slider, output] =
      [".controls", "button", "[type=range]", "output"].map((name) => part.querySelector(name));
    const last = data.frames - 1;
    let frame = 0;
    function go(to) {
      frame = to;
      const words = `frame ${frame} / ${last} · ${(frame / data.rate).toFixed(2)} s`;
      slider.value = frame;
      slider.setAttribute("aria-valuetext", words);
      output.textContent = words;
      show(frame);
    }
    /** What plays: the frame and the time in milliseconds at which it began; null for a pause. */
    let playing = null;
    function pause() {
      playing = null;
      button.textContent = "Play";
    }
    function play() {
      const begin = { frame, time: null };
      const tick = (time) => {
        if (playing !== begin) return;
        begin.time ??= time;
        const next = mesh.frameAfter(data, begin.frame, (time - begin.time) / 1000);
        if (next !== frame) go(next);
        requestAnimationFrame(tick);
      };
      playing = begin;
      button.textContent = "Pause";
      requestAnimationFrame(tick);
    }
    const toggle = () => (playing ? pause() : play());
    function step(frames) {
      pause();
      go((frame + frames + data.frames) % data.frames);
    }
    button.addEventListener("click", toggle);
    slider.addEventListener("input", () => {
      pause();
      go(Number(slider.value));
    });
    part.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      // The space bar presses the button without this.
      if (event.key === " " && event.target !== button) toggle();
      else if (event.key === ",") step(-1);
      else if (event.key === ".") step(1);
      else return;
      event.preventDefault();
    });
    controls.hidden = false;
    go(0);
  }

  addEventListener("DOMContentLoaded", () => document.querySelectorAll(".model").forEach(start));
})();
