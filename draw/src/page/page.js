"use strict";
(() => {
  const data = JSON.parse(document.getElementById("scene").textContent);
  const { picture } = data;
  const stage = document.getElementById("stage");
  const context = stage.getContext("2d");
  if (!context) return;

  const EYE = 4, TAU = 2 * Math.PI;
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const along = (a, b, t) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
  const difference = (a, b) => along(a, b, -1);
  const scaled = (a, t) => a.map((x) => x * t);

  const start = { azimuth: data.azimuth, elevation: data.elevation, zoom: data.zoom };
  let view = { ...start };
  const shown = data.elements.map(() => true);
  const isShown = (item) => item.element === null || shown[item.element];

  const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

  function readFragment() {
    const found = new URLSearchParams(location.hash.slice(1));
    view = { ...start };
    const turn = (found.get("turn") || "").split(",").map(Number);
    if (turn.length === 2 && turn.every(Number.isFinite)) {
      view.azimuth = turn[0] % 360;
      view.elevation = clamp(turn[1], -90, 90);
    }
    const zoom = Number(found.get("zoom"));
    if (Number.isFinite(zoom) && zoom > 0) view.zoom = clamp(zoom, 0.1, 20);
  }

  function makeCamera(width, height) {
    const radians = Math.PI / 180;
    const [sa, ca] = [Math.sin(view.azimuth * radians), Math.cos(view.azimuth * radians)];
    const [se, ce] = [Math.sin(view.elevation * radians), Math.cos(view.elevation * radians)];
    const [ahead, aside, up] = data.axes;
    const out = along(scaled(ahead, ca), aside, sa);
    const right = along(scaled(aside, ca), ahead, -sa);
    const toward = along(scaled(out, ce), up, se);
    const upward = cross(toward, right);
    // Patches reach beyond the ball that holds the rest.
    const room = picture.patches.length ? 2.8 : 2.05;
    const scale = (view.zoom * Math.min(width, height - 40)) / room;
    const depth = (p) => dot(p, toward);
    const ray = (p) => {
      if (!data.perspective) return [toward, Infinity];
      const way = difference(scaled(toward, EYE), p);
      const distance = Math.max(Math.sqrt(dot(way, way)), 1e-9);
      return [scaled(way, 1 / distance), distance];
    };
    const project = (p) => {
      const s = data.perspective ? (scale * EYE) / Math.max(EYE - depth(p), 0.2) : scale;
      return [width / 2 + s * dot(p, right), height / 2 + 6 - s * dot(p, upward)];
    };
    return { toward, depth, ray, project, middle: [width / 2, height / 2], width, height };
  }

  function behindBall(camera, point, ball) {
    const [ray] = camera.ray(point);
    const from = difference(point, ball.centre);
    const ahead = dot(from, ray);
    const discriminant = ahead * ahead - dot(from, from) + ball.radius * ball.radius;
    return discriminant > 0 && Math.sqrt(discriminant) - ahead > 1e-4 + 0.02 * ball.radius;
  }

  function behindPatch(camera, point, patch) {
    const [ray, distance] = camera.ray(point);
    const slope = dot(patch.normal, ray);
    if (Math.abs(slope) < 1e-6) return false;
    const t = dot(patch.normal, difference(patch.corners[0], point)) / slope;
    if (!(t > 1e-3 && t < distance)) return false;
    const through = along(point, ray, t);
    return patch.corners.every((from, k) => {
      const to = patch.corners[(k + 1) % patch.corners.length];
      return dot(cross(difference(to, from), difference(through, from)), patch.normal) >= 0;
    });
  }

  /** The outline of a ball as points in space. */
  function outline(camera, ball) {
    const [m, distance] = camera.ray(ball.centre);
    const height = Math.min((ball.radius * ball.radius) / distance, 0.999 * ball.radius);
    const radius = Math.sqrt(Math.max(ball.radius * ball.radius - height * height, 0));
    let u = cross(data.axes[2], m);
    const size = Math.sqrt(dot(u, u));
    u = size > 1e-6 ? scaled(u, 1 / size) : data.axes[0];
    const v = cross(m, u);
    const centre = along(ball.centre, m, height);
    const points = [];
    for (let k = 0; k <= 96; k++) {
      const angle = (TAU * (k % 96)) / 96;
      points.push(along(along(centre, u, radius * Math.cos(angle)), v, radius * Math.sin(angle)));
    }
    return points;
  }

  /** What of a curve is visible or hidden, as runs of points. */
  function strokes(camera, curve, hidden) {
    const runs = [];
    let state = hidden(curve.points[0]);
    let run = [curve.points[0]];
    const finish = () => {
      if (run.length > 1) {
        const depth = run.reduce((sum, p) => sum + camera.depth(p), 0) / run.length;
        runs.push({ points: run, hidden: state, depth, curve });
      }
    };
    for (let k = 1; k < curve.points.length; k++) {
      const [from, to] = [curve.points[k - 1], curve.points[k]];
      const next = hidden(to);
      if (next !== state) {
        let [low, high] = [0, 1];
        for (let n = 0; n < 8; n++) {
          const middle = (low + high) / 2;
          if (hidden(along(from, difference(to, from), middle)) === state) low = middle;
          else high = middle;
        }
        const between = along(from, difference(to, from), high);
        run.push(between);
        finish();
        run = [between];
        state = next;
      } else if (!state && !curve.dashed && run.length >= 24) {
        const last = run[run.length - 1];
        finish();
        run = [last];
      }
      run.push(to);
    }
    finish();
    if (curve.arrow && runs.length) runs[runs.length - 1].head = curve.points;
    return runs;
  }

  function path(camera, points) {
    context.beginPath();
    points.forEach((p, k) => {
      const [x, y] = camera.project(p);
      if (k) context.lineTo(x, y);
      else context.moveTo(x, y);
    });
  }

  function drawStroke(camera, run) {
    const { curve } = run;
    context.globalAlpha = (run.hidden ? 0.7 : 1) * curve.opacity;
    context.strokeStyle = context.fillStyle = curve.colour;
    context.lineWidth = (run.hidden ? 0.8 : 1) * curve.width;
    context.setLineDash(run.hidden ? (curve.dashed ? [2, 6] : [3, 4]) : curve.dashed ? [8, 5] : []);
    context.lineCap = run.hidden || curve.dashed ? "butt" : "round";
    path(camera, run.points);
    context.stroke();
    context.setLineDash([]);
    if (run.head) {
      const points = run.head;
      const last = points[points.length - 1];
      let before = points.length - 2;
      while (before > 0 && points[before].every((x, k) => x === last[k])) before--;
      const step = difference(last, points[before]);
      const behind = along(last, step, -0.05 / Math.max(Math.sqrt(dot(step, step)), 1e-9));
      const [a, b] = [camera.project(behind), camera.project(last)];
      const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
      if (long > 0.75) {
        const [dx, dy] = [(b[0] - a[0]) / long, (b[1] - a[1]) / long];
        const [size, half] = [6 + 2.4 * curve.width, 2.4 + 1.1 * curve.width];
        const tip = [b[0] + 0.35 * size * dx, b[1] + 0.35 * size * dy];
        const foot = [tip[0] - size * dx, tip[1] - size * dy];
        context.beginPath();
        context.moveTo(...tip);
        context.lineTo(foot[0] - half * dy, foot[1] + half * dx);
        context.lineTo(foot[0] + half * dy, foot[1] - half * dx);
        context.fill();
      }
    }
    context.globalAlpha = 1;
  }

  const mixed = (colour, grey, part, alpha) => {
    const parts = [1, 3, 5].map((k) => parseInt(colour.slice(k, k + 2), 16));
    return `rgba(${parts.map((x) => Math.round(x * (1 - part) + grey * part)).join()},${alpha})`;
  };

  function drawBall(camera, ball, points) {
    const pixels = points.map(camera.project);
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
    path(camera, points);
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

  const SIDES = [[0.8, -0.8], [-0.8, -0.8], [0.8, 0.8], [-0.8, 0.8], [1, 0], [-1, 0], [0, -1], [0, 1]];

  function drawLabels(camera, ink, faint, ground) {
    const taken = picture.dots.filter(isShown).map((item) => {
      const [x, y] = camera.project(item.at);
      return [x - item.radius, y - item.radius, x + item.radius, y + item.radius];
    });
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    for (const strong of [true, false]) {
      for (const label of picture.labels) {
        if (label.strong !== strong || !isShown(label)) continue;
        context.font = `${strong ? 600 : 400} 15px system-ui, "Segoe UI", "DejaVu Sans", sans-serif`;
        const at = camera.project(label.at);
        const half = [context.measureText(label.text).width / 2, 8];
        const away = [at[0] - camera.middle[0], at[1] - camera.middle[1]];
        const places = SIDES.map(([x, y]) => {
          const middle = [at[0] + x * (half[0] + 8), at[1] + y * (half[1] + 8)];
          const own = [middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1]];
          const outside = own[0] < 2 || own[1] < 2 || own[2] > camera.width - 2 || own[3] > camera.height - 2;
          let cost = outside ? 1e4 : 0;
          for (const box of taken) {
            const wide = Math.min(own[2], box[2]) - Math.max(own[0], box[0]);
            const high = Math.min(own[3], box[3]) - Math.max(own[1], box[1]);
            if (wide > 0 && high > 0) cost += wide * high;
          }
          return { middle, own, cost, preference: x * away[0] + y * away[1] };
        });
        places.sort((a, b) => a.cost - b.cost || b.preference - a.preference);
        const { middle, own } = places[0];
        taken.push(own);
        context.strokeStyle = ground;
        context.lineWidth = 3.5;
        context.strokeText(label.text, ...middle);
        context.fillStyle = strong ? ink : faint;
        context.fillText(label.text, ...middle);
      }
    }
  }

  function draw() {
    const { clientWidth: width, clientHeight: height } = stage;
    const ratio = window.devicePixelRatio || 1;
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (stage.width !== wide || stage.height !== high) [stage.width, stage.height] = [wide, high];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    const colours = getComputedStyle(document.documentElement);
    const [ground, ink, faint] = ["--ground", "--ink", "--faint"].map((name) => colours.getPropertyValue(name).trim());
    const camera = makeCamera(width, height);
    const balls = picture.balls.filter(isShown);
    const patches = picture.patches.filter(isShown);
    const outlines = new Map(balls.map((ball) => [ball, outline(camera, ball)]));
    const hidingBalls = balls.filter((ball) => !ball.imaginary && ball.opacity > 0.02);
    const hidingPatches = patches.filter((patch) => patch.opacity > 0.02);
    const hidden = (point) =>
      hidingBalls.some((ball) => behindBall(camera, point, ball)) ||
      hidingPatches.some((patch) => behindPatch(camera, point, patch));
    // What only translucent surfaces hide is painted over them, so that it keeps its colour.
    const dense = {
      balls: hidingBalls.filter((ball) => ball.opacity > 0.9),
      patches: hidingPatches.filter((patch) => patch.opacity > 0.9),
    };
    const isBuried = (point) =>
      dense.balls.some((ball) => behindBall(camera, point, ball)) ||
      dense.patches.some((patch) => behindPatch(camera, point, patch));

    const curves = picture.curves.filter(isShown).concat(
      balls.map((ball) => ({
        colour: ball.colour,
        points: outlines.get(ball),
        width: ball.width,
        opacity: 1,
        dashed: ball.imaginary,
        arrow: false,
      })),
    );
    const runs = curves.flatMap((curve) => strokes(camera, curve, hidden));
    const dots = picture.dots.filter(isShown).map((item) => ({ item, hidden: hidden(item.at), depth: camera.depth(item.at) + 0.1 }));
    const paint = (thing) => (thing.curve ? drawStroke(camera, thing) : drawDot(camera, thing.item, thing.hidden, ground));
    const place = (thing) => (thing.curve ? thing.points[thing.points.length >> 1] : thing.item.at);
    const things = runs.concat(dots).sort((a, b) => a.depth - b.depth);
    const [buried, seen] = [[], []];
    for (const thing of things) (thing.hidden && isBuried(place(thing)) ? buried : seen).push(thing);
    buried.forEach(paint);
    const middle = (patch) => scaled(patch.corners.reduce((sum, p) => along(sum, p, 1), [0, 0, 0]), 1 / patch.corners.length);
    const surfaces = balls
      .map((ball) => ({ ball, depth: camera.depth(ball.centre) }))
      .concat(patches.map((patch) => ({ patch, depth: camera.depth(middle(patch)) })))
      .sort((a, b) => a.depth - b.depth);
    for (const { ball, patch } of surfaces) {
      if (ball) drawBall(camera, ball, outlines.get(ball));
      else {
        context.globalAlpha = patch.opacity;
        context.fillStyle = patch.colour;
        path(camera, patch.corners);
        context.fill();
        context.globalAlpha = 1;
      }
    }
    seen.filter((thing) => thing.hidden).forEach(paint);
    seen.filter((thing) => !thing.hidden).forEach(paint);
    drawLabels(camera, ink, faint, ground);
  }

  let waiting = false;
  function redraw() {
    if (waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      draw();
    });
  }

  function turn(azimuth, elevation) {
    view.azimuth = (view.azimuth + azimuth) % 360;
    view.elevation = clamp(view.elevation + elevation, -90, 90);
    redraw();
  }
  function zoom(factor) {
    view.zoom = clamp(view.zoom * factor, 0.1, 20);
    redraw();
  }
  function reset() {
    view = { ...start };
    redraw();
  }

  const fingers = new Map();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  stage.addEventListener("pointerdown", (event) => {
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    stage.setPointerCapture(event.pointerId);
  });
  stage.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const before = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (fingers.size === 1) turn(-0.4 * (event.clientX - last[0]), 0.4 * (event.clientY - last[1]));
    else if (before > 0) zoom(spread() / before);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  stage.addEventListener("wheel", (event) => {
    event.preventDefault();
    zoom(Math.exp(-clamp(event.deltaY, -300, 300) / 600));
  }, { passive: false });
  stage.addEventListener("dblclick", reset);
  const KEYS = {
    ArrowLeft: () => turn(5, 0),
    ArrowRight: () => turn(-5, 0),
    ArrowUp: () => turn(0, 5),
    ArrowDown: () => turn(0, -5),
    "+": () => zoom(1.15),
    "=": () => zoom(1.15),
    "-": () => zoom(1 / 1.15),
    0: reset,
    Home: reset,
  };
  stage.addEventListener("keydown", (event) => {
    const act = Object.hasOwn(KEYS, event.key) && !event.ctrlKey && !event.metaKey && !event.altKey && KEYS[event.key];
    if (!act) return;
    event.preventDefault();
    act();
  });

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
