/** The page: paints the scene on the canvas, and follows the address and the legend. */
(() => {
  const { LETTER, TAU, clamp, fittedCamera, hiding, outlineCurve, placeLabels, strokes } = geometry;
  const { cleared, oncePerPainting, turntable } = stages;
  const data = JSON.parse(document.getElementById("scene").textContent);
  const { picture } = data;
  const stage = document.getElementById("stage");
  const context = stage.getContext("2d");
  if (!context) return;

  const start = { azimuth: data.azimuth, elevation: data.elevation, zoom: data.zoom };
  const view = { ...start };
  const shown = data.elements.map(() => true);
  const isShown = (item) => item.element === null || shown[item.element];

  function readFragment() {
    const found = new URLSearchParams(location.hash.slice(1));
    Object.assign(view, start);
    const angles = (found.get("turn") || "").split(",").map(Number);
    if (angles.length === 2 && angles.every(Number.isFinite)) {
      view.azimuth = angles[0] % 360;
      view.elevation = clamp(angles[1], -90, 90);
    }
    const zoom = Number(found.get("zoom"));
    if (Number.isFinite(zoom) && zoom > 0) view.zoom = clamp(zoom, 0.1, 20);
  }

  function path(camera, points) {
    context.beginPath();
    points.forEach((p, k) => {
      const [x, y] = camera.project(p);
      if (k) context.lineTo(x, y);
      else context.moveTo(x, y);
    });
  }

  function drawStroke(camera, part) {
    const { curve } = part;
    context.globalAlpha = (part.hidden ? 0.7 : 1) * curve.opacity;
    context.strokeStyle = context.fillStyle = curve.colour;
    context.lineWidth = (part.hidden ? 0.8 : 1) * curve.width;
    context.setLineDash(part.hidden ? (curve.dashed ? [2, 6] : [3, 4]) : curve.dashed ? [8, 5] : []);
    context.lineCap = part.hidden || curve.dashed ? "butt" : "round";
    path(camera, part.points);
    context.stroke();
    context.setLineDash([]);
    if (part.head) {
      context.beginPath();
      context.moveTo(...part.head[0]);
      context.lineTo(...part.head[1]);
      context.lineTo(...part.head[2]);
      context.fill();
    }
    context.globalAlpha = 1;
  }

  const mixed = (colour, grey, part, alpha) => {
    const parts = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
    return `rgba(${parts.map((x) => Math.round(x * (1 - part) + grey * part)).join()},${alpha})`;
  };

  function drawBall(ball, pixels) {
    const low = [0, 1].map((k) => Math.min(...pixels.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...pixels.map((p) => p[k])));
    const at = (x, y) => [low[0] + x * (high[0] - low[0]), low[1] + y * (high[1] - low[1])];
    const radius = Math.max(high[0] - low[0], high[1] - low[1]) / 2;
    const gradient = context.createRadialGradient(...at(0.36, 0.3), 0, ...at(0.5, 0.5), radius);
    const opacity = (power) => 1 - Math.pow(1 - ball.opacity, power);
    gradient.addColorStop(0, mixed(ball.colour, 255, 0.62, opacity(0.6)));
    gradient.addColorStop(0.62, mixed(ball.colour, 0, 0, opacity(1)));
    gradient.addColorStop(1, mixed(ball.colour, 0, 0.22, opacity(1.9)));
    context.fillStyle = gradient;
    addOutlines([pixels]);
    context.fill();
  }

  function drawDot(camera, item, hidden, ground) {
    const [x, y] = camera.project(item.at);
    const r = item.radius;
    context.globalAlpha = hidden ? 0.75 : 1;
    context.beginPath();
    if (item.form === "square") context.rect(x - r, y - r, 2 * r, 2 * r);
    else context.arc(x, y, item.form === "hollow" ? r - 1 : r, 0, TAU);
    context.fillStyle = item.form === "hollow" ? ground : item.colour;
    context.strokeStyle = item.form === "hollow" ? item.colour : ground;
    context.lineWidth = item.form === "hollow" ? 2 : 1;
    context.fill();
    context.stroke();
    context.globalAlpha = 1;
  }

  function drawLabels(camera, size, { ground, ink, faint }) {
    const fontOf = (label) =>
      `${label.strong ? 600 : 400} ${LETTER}px system-ui, "Segoe UI", "DejaVu Sans", sans-serif`;
    const widthOf = (label) => {
      context.font = fontOf(label);
      return context.measureText(label.text).width;
    };
    const shownParts = {
      labels: picture.labels.filter(isShown),
      dots: picture.dots.filter(isShown),
      curves: picture.curves.filter(isShown),
    };
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    for (const { label, middle, leader } of placeLabels(camera, size, shownParts, widthOf)) {
      if (leader) {
        context.beginPath();
        context.moveTo(...leader[0]);
        context.lineTo(...leader[1]);
        context.strokeStyle = faint;
        context.lineWidth = 0.8;
        context.stroke();
      }
      context.font = fontOf(label);
      context.strokeStyle = ground;
      context.lineWidth = 3.5;
      context.strokeText(label.text, ...middle);
      context.fillStyle = label.strong ? ink : faint;
      context.fillText(label.text, ...middle);
    }
  }

  /** Adds closed paths of pixels to the path of the canvas. */
  function addOutlines(outlines) {
    context.beginPath();
    for (const points of outlines) {
      points.forEach(([x, y], k) => (k ? context.lineTo(x, y) : context.moveTo(x, y)));
      context.closePath();
    }
  }

  /** Balls and patches in pieces, each after those that it hides. */
  function drawSurfaces(camera, balls, patches) {
    for (const { ball, patch, regions } of surface.pieces(camera, balls, patches)) {
      if (regions.some((region) => region.length === 0)) continue;
      if (patch) {
        context.globalAlpha = patch.opacity;
        context.fillStyle = patch.colour;
        addOutlines(regions[0]);
        context.fill();
        context.globalAlpha = 1;
        continue;
      }
      context.save();
      for (const region of regions.slice(1)) {
        addOutlines(region);
        context.clip("evenodd");
      }
      drawBall(ball, regions[0][0]);
      context.restore();
    }
  }

  /** The colours of the page, which follow the reader's preference for light or dark. */
  function pageColours() {
    const style = getComputedStyle(document.documentElement);
    const of = (name) => style.getPropertyValue(name).trim();
    return { ground: of("--ground"), ink: of("--ink"), faint: of("--faint") };
  }

  function draw() {
    const size = cleared(stage, context);
    const colours = pageColours();
    const camera = fittedCamera(data, view, size);
    const balls = picture.balls.filter(isShown);
    const patches = picture.patches.filter(isShown);
    const isHidden = hiding(camera, balls, patches, 0.02);
    // What only translucent surfaces hide is painted over them, so that it keeps its colour.
    const isBuried = hiding(camera, balls, patches, 0.9);
    const curves = picture.curves.filter(isShown).concat(balls.map((ball) => outlineCurve(camera, ball)));
    const parts = curves.flatMap((curve) => strokes(camera, curve, isHidden));
    // A dot lies on the lines through it.
    const dots = picture.dots.filter(isShown).map((item) => ({
      item,
      hidden: isHidden(item.at),
      depth: camera.depth(item.at) + 0.1,
    }));
    const paint = (thing) => {
      if (thing.curve) drawStroke(camera, thing);
      else drawDot(camera, thing.item, thing.hidden, colours.ground);
    };
    const anchor = ({ points, item }) => (points ? points[points.length >> 1] : item.at);
    const things = parts.concat(dots).sort((a, b) => a.depth - b.depth);
    const buried = (thing) => thing.hidden && isBuried(anchor(thing));
    const [under, over] = [things.filter(buried), things.filter((thing) => !buried(thing))];
    under.forEach(paint);
    drawSurfaces(camera, balls, patches);
    over.filter((thing) => thing.hidden).forEach(paint);
    over.filter((thing) => !thing.hidden).forEach(paint);
    drawLabels(camera, size, colours);
  }

  const redraw = oncePerPainting(draw);
  turntable(stage, view, start, redraw);

  const legend = document.getElementById("legend");
  data.elements.forEach((element, index) => {
    if (element.label === null) return;
    const button = document.createElement("button");
    const swatch = document.createElement("i");
    swatch.style.background = element.colour;
    const kind = document.createElement("span");
    kind.textContent = element.kind;
    button.append(swatch, element.label, kind);
    button.setAttribute("aria-pressed", "true");
    button.addEventListener("click", () => {
      shown[index] = !shown[index];
      button.setAttribute("aria-pressed", String(shown[index]));
      redraw();
    });
    const line = document.createElement("li");
    line.append(button);
    legend.append(line);
  });

  document.getElementById("still").hidden = true;
  stage.hidden = false;
  legend.hidden = legend.children.length === 0;
  document.querySelector("footer").hidden = false;
  readFragment();
  draw();
  new ResizeObserver(redraw).observe(stage);
  addEventListener("hashchange", () => {
    readFragment();
    redraw();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);
})();
