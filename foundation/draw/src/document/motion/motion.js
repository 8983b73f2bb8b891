/** Plays the motions of the page, and follows the pointer, the keys and the slider. */
(() => {
  const { cleared, oncePerPainting, turntable } = stages;
  /** The number of pictures of a film that are decoded before they are shown. */
  const AHEAD = 8;
  /** The distance from a point at which the mouse shows its name, in pixels. */
  const NEAR = 14;

  const path = (context, ends) => {
    context.beginPath();
    context.moveTo(...ends[0]);
    context.lineTo(...ends[1]);
    context.stroke();
  };

  /** A film on its canvas. Pictures are decoded before they are needed, and kept while near. */
  function makeFilm(film, canvas, note) {
    const context = canvas.getContext("2d");
    const decoded = new Map();
    const load = (index) => {
      if (!decoded.has(index)) {
        const image = new Image();
        image.src = film.pictures[index].source;
        decoded.set(index, image.decode().then(() => image, () => null));
      }
      return decoded.get(index);
    };
    /** Decodes the picture of a frame and begins with the following ones; gives a painter. */
    async function prepare(frame) {
      const index = figure.pictureAt(film, frame);
      if (index === null) return () => say("no picture of this frame");
      for (const old of decoded.keys()) {
        if (old < index - AHEAD || old > index + AHEAD) decoded.delete(old);
      }
      const end = Math.min(index + AHEAD + 1, film.pictures.length);
      for (let next = index; next < end; next++) load(next);
      const image = await load(index);
      if (!image) return () => say("the picture of this frame cannot be read");
      const { start, end: until } = film.pictures[index];
      return () => {
        context.clearRect(0, 0, canvas.width, canvas.height);
        context.drawImage(image, 0, 0, canvas.width, canvas.height);
        note.textContent = until > start + 1 ? `· picture of frames ${start} to ${until - 1}` : "";
      };
    }
    function say(words) {
      context.clearRect(0, 0, canvas.width, canvas.height);
      note.textContent = `· ${words}`;
    }
    return prepare;
  }

  function start(part) {
    const find = (selector) => part.querySelector(selector);
    const stage = find(".stage");
    const context = stage.getContext("2d");
    if (!context) return;
    const data = JSON.parse(find("script").textContent);
    const [button, slider, output, follow] =
      ["button", "[type=range]", "output", "[type=checkbox]"].map(find);
    const canvases = [...part.querySelectorAll(".films canvas")];
    const notes = [...part.querySelectorAll(".films span")];
    const films = data.films.map((film, k) => makeFilm(film, canvases[k], notes[k]));
    const last = data.frames.length - 1;

    const front = { azimuth: data.azimuth, elevation: data.elevation, zoom: 1 };
    const view = { ...front };
    /** The frame that is shown, and the one that is asked for. */
    let [shown, wanted] = [null, null];
    let mouse = null;
    /** The place in the middle of the canvas. */
    let centre = data.middle;

    /** Writes above a pixel, inside the canvas. */
    function label(text, [x, y], [width], colours) {
      if (x < 0 || x > width) return;
      context.font = '13px system-ui, "Segoe UI", "DejaVu Sans", sans-serif';
      context.textAlign = "center";
      const half = context.measureText(text).width / 2 + 4;
      x = Math.max(Math.min(x, width - half), half);
      context.lineJoin = "round";
      context.lineWidth = 3.5;
      context.strokeStyle = colours.ground;
      context.strokeText(text, x, y);
      context.fillStyle = colours.ink;
      context.fillText(text, x, y);
    }

    function draw() {
      const size = cleared(stage, context);
      const style = getComputedStyle(stage);
      const of = (name) => style.getPropertyValue(name).trim();
      const [ground, ink, faint] = ["--ground", "--ink", "--faint"].map(of);
      const points = figure.pose(data, shown);
      if (!follow.checked) centre = data.middle;
      else if (points) centre = figure.centre(data, points);
      const camera = figure.camera(data, view, size, centre);
      const lines = (numbers, colour) => {
        context.lineWidth = 1;
        context.strokeStyle = colour;
        for (let k = 0; k < numbers.length / 3; k += 2) {
          path(context, [camera.project(numbers, k), camera.project(numbers, k + 1)]);
        }
      };
      lines(data.floor, of("--floor"));
      for (const pyramid of data.cameras) lines(pyramid.lines, faint);
      for (const { name, lines } of data.cameras) {
        const [x, y] = camera.project(lines, 0);
        label(name, [x, y - 6], size, { ground, ink: faint });
      }
      if (!points) {
        label("no pose in this frame", [size[0] / 2, 22], size, { ground, ink });
        return;
      }
      context.lineCap = "round";
      context.lineWidth = 4;
      for (const { ends, side } of figure.bones(data, camera, points)) {
        context.strokeStyle = data.colours[side];
        path(context, ends);
      }
      context.fillStyle = ink;
      const pixels = data.names.map((_, k) => camera.project(points, k));
      for (const [x, y] of pixels) {
        context.beginPath();
        context.arc(x, y, 2.5, 0, geometry.TAU);
        context.fill();
      }
      const near = mouse && figure.nearest(pixels, mouse, NEAR);
      if (near === null) return;
      const [x, y] = pixels[near];
      label(data.names[near], [x, y - 10], size, { ground, ink });
    }
    const redraw = oncePerPainting(draw);

    /**
     * Shows a frame as soon as all its pictures are decoded, so that the figure and the films
     * always show the same one; of frames that are asked for meanwhile, the last is shown.
     */
    let loading = false;
    async function show(frame) {
      wanted = frame;
      if (loading) return;
      loading = true;
      while (shown !== wanted) {
        const frame = wanted;
        const painters = await Promise.all(films.map((prepare) => prepare(frame)));
        shown = frame;
        painters.forEach((paint) => paint());
        const words = `frame ${frame} / ${last} · ${(frame / data.rate).toFixed(2)} s`;
        slider.value = frame;
        slider.setAttribute("aria-valuetext", words);
        output.textContent = words;
        draw();
      }
      loading = false;
    }

    /** What plays: the frame and the time in milliseconds at which it began; null for a pause. */
    let playing = null;
    function pause() {
      playing = null;
      button.textContent = "Play";
    }
    function play() {
      const begin = { frame: wanted === last ? 0 : wanted, time: null };
      const tick = (time) => {
        if (playing !== begin) return;
        begin.time ??= time;
        const frame = figure.frameAfter(data, begin.frame, (time - begin.time) / 1000);
        show(frame);
        if (frame === last) pause();
        else requestAnimationFrame(tick);
      };
      playing = begin;
      button.textContent = "Pause";
      requestAnimationFrame(tick);
    }
    const toggle = () => (playing ? pause() : play());
    function step(frames) {
      pause();
      show(Math.min(Math.max(wanted + frames, 0), last));
    }

    button.addEventListener("click", toggle);
    slider.addEventListener("input", () => {
      pause();
      show(Number(slider.value));
    });
    part.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      // The space bar presses the button and the box without this.
      if (event.key === " " && event.target !== button && event.target !== follow) toggle();
      else if (event.key === ",") step(-1);
      else if (event.key === ".") step(1);
      else return;
      event.preventDefault();
    });
    follow.addEventListener("change", redraw);
    turntable(stage, view, front, redraw);
    stage.addEventListener("pointermove", (event) => {
      const { left, top } = stage.getBoundingClientRect();
      mouse = [event.clientX - left, event.clientY - top];
      redraw();
    });
    stage.addEventListener("pointerleave", () => {
      mouse = null;
      redraw();
    });

    find(".still").hidden = true;
    for (const name of [".views", ".controls", ".help"]) find(name).hidden = false;
    const first = data.frames.findIndex((pose) => pose !== null);
    show(first).then(() => new ResizeObserver(redraw).observe(stage));
  }

  addEventListener("DOMContentLoaded", () => document.querySelectorAll(".motion").forEach(start));
})();
