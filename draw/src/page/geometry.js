"use strict";
/**
 * The mathematics of the page: the camera, what hides what, and the places of labels. It needs no
 * document. It repeats the modules camera, stroke and label of ga-draw, whose tests compare the
 * two.
 *
 * A point is [x, y, z] in the coordinates of the picture, a pixel is [x, y].
 */
const geometry = (() => {
  /** The distance of the eye from the middle of the scene; the scene has radius 1. */
  const EYE = 4;
  const TAU = 2 * Math.PI;

  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const cross = (a, b) => [
    a[1] * b[2] - a[2] * b[1],
    a[2] * b[0] - a[0] * b[2],
    a[0] * b[1] - a[1] * b[0],
  ];
  /** a + t b */
  const along = (a, b, t) => [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]];
  const difference = (a, b) => along(a, b, -1);
  const scaled = (a, t) => a.map((x) => x * t);
  const length = (a) => Math.sqrt(dot(a, a));
  const clamp = (x, low, high) => Math.min(Math.max(x, low), high);

  /**
   * A camera. `axes` are the horizontal axes at azimuth 0 and 90 degrees and the upward axis,
   * `scale` is the number of pixels of a unit, and `middle` the pixel of the scene's middle.
   */
  function makeCamera({ azimuth, elevation, perspective, axes, scale, middle }) {
    const radians = Math.PI / 180;
    const [sa, ca] = [Math.sin(azimuth * radians), Math.cos(azimuth * radians)];
    const [se, ce] = [Math.sin(elevation * radians), Math.cos(elevation * radians)];
    const [ahead, aside, up] = axes;
    const out = along(scaled(ahead, ca), aside, sa);
    const right = along(scaled(aside, ca), ahead, -sa);
    const toward = along(scaled(out, ce), up, se);
    const upward = cross(toward, right);
    const depth = (p) => dot(p, toward);
    /** The direction from a point to the eye, of length 1, and the distance of the eye. */
    const ray = (p) => {
      if (!perspective) return [toward, Infinity];
      const way = difference(scaled(toward, EYE), p);
      const distance = Math.max(length(way), 1e-9);
      return [scaled(way, 1 / distance), distance];
    };
    const project = (p) => {
      const s = perspective ? (scale * EYE) / Math.max(EYE - depth(p), 0.2) : scale;
      return [middle[0] + s * dot(p, right), middle[1] - s * dot(p, upward)];
    };
    return { depth, ray, project, scale, middle };
  }

  /** The camera with which a picture fits into a canvas. */
  function fittedCamera(data, view, [width, height]) {
    // Patches reach beyond the ball that contains the rest.
    const room = data.picture.patches.length ? 2.8 : 2.05;
    return makeCamera({
      azimuth: view.azimuth,
      elevation: view.elevation,
      perspective: data.perspective,
      axes: data.axes,
      scale: (view.zoom * Math.min(width, height - 40)) / room,
      middle: [width / 2, height / 2 + 6],
    });
  }

  /** Whether a ball hides a point. A point on its front is not hidden. */
  function isBehindBall(camera, point, ball) {
    const [ray] = camera.ray(point);
    const from = difference(point, ball.centre);
    const ahead = dot(from, ray);
    const discriminant = ahead * ahead - dot(from, from) + ball.radius * ball.radius;
    return discriminant > 0 && Math.sqrt(discriminant) - ahead > 1e-4 + 0.02 * ball.radius;
  }

  /** Whether a patch hides a point. A point on it is not hidden. */
  function isBehindPatch(camera, point, patch) {
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

  /**
   * Whether a surface of more than a given opacity hides a point. Imaginary balls hide nothing.
   */
  function hiding(camera, balls, patches, opacity) {
    const hidingBalls = balls.filter((ball) => !ball.imaginary && ball.opacity > opacity);
    const hidingPatches = patches.filter((patch) => patch.opacity > opacity);
    return (point) =>
      hidingBalls.some((ball) => isBehindBall(camera, point, ball)) ||
      hidingPatches.some((patch) => isBehindPatch(camera, point, patch));
  }

  /**
   * Two vectors u and v that form a right-handed orthonormal basis with a unit vector. u is
   * horizontal; where the unit vector is vertical, u is the x axis.
   */
  function basisAcross(normal) {
    const isHorizontal = length(cross([0, 0, 1], normal)) < 1e-6;
    const u = cross(isHorizontal ? [0, normal[2], 0] : [0, 0, 1], normal);
    const unit = scaled(u, 1 / length(u));
    return [unit, cross(normal, unit)];
  }

  /** The outline of a ball as points in space. */
  function outline(camera, ball) {
    const [m, distance] = camera.ray(ball.centre);
    const height = Math.min((ball.radius * ball.radius) / distance, 0.999 * ball.radius);
    const radius = Math.sqrt(Math.max(ball.radius * ball.radius - height * height, 0));
    const centre = along(ball.centre, m, height);
    const [u, v] = basisAcross(m);
    const points = [];
    for (let k = 0; k <= 96; k++) {
      const angle = (TAU * (k % 96)) / 96;
      points.push(along(along(centre, u, radius * Math.cos(angle)), v, radius * Math.sin(angle)));
    }
    return points;
  }

  /** The outline of a ball as a curve. */
  const outlineCurve = (camera, ball) => ({
    colour: ball.colour,
    points: outline(camera, ball),
    width: ball.width,
    opacity: 1,
    dashed: ball.imaginary,
    arrow: false,
  });

  /** The parts of a curve, each of them all visible or all hidden. */
  function strokes(camera, curve, isHidden) {
    const parts = [];
    let state = isHidden(curve.points[0]);
    let part = [curve.points[0]];
    const finish = () => {
      if (part.length > 1) {
        const depth = part.reduce((sum, p) => sum + camera.depth(p), 0) / part.length;
        parts.push({ points: part, hidden: state, depth, curve });
      }
    };
    for (let k = 1; k < curve.points.length; k++) {
      const [from, to] = [curve.points[k - 1], curve.points[k]];
      const next = isHidden(to);
      if (next !== state) {
        let [low, high] = [0, 1];
        for (let n = 0; n < 10; n++) {
          const middle = (low + high) / 2;
          if (isHidden(along(from, difference(to, from), middle)) === state) low = middle;
          else high = middle;
        }
        const between = along(from, difference(to, from), high);
        part.push(between);
        finish();
        part = [between];
        state = next;
      } else if (!state && !curve.dashed && part.length >= 24) {
        const last = part[part.length - 1];
        finish();
        part = [last];
      }
      part.push(to);
    }
    finish();
    if (curve.arrow && parts.length) {
      parts[parts.length - 1].head = arrowHead(camera, curve.points, curve.width);
    }
    return parts;
  }

  /** The corners of the arrow's head at the end of a curve; null where it points to the eye. */
  function arrowHead(camera, points, width) {
    const end = points[points.length - 1];
    let before = points.length - 2;
    while (before > 0 && points[before].every((x, k) => x === end[k])) before--;
    const step = difference(end, points[before]);
    const behind = along(end, step, -0.05 / Math.max(length(step), 1e-9));
    const [a, b] = [camera.project(behind), camera.project(end)];
    const long = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (long < 0.75) return null;
    const [dx, dy] = [(b[0] - a[0]) / long, (b[1] - a[1]) / long];
    const [size, half] = [6 + 2.4 * width, 2.4 + 1.1 * width];
    const tip = [b[0] + 0.35 * size * dx, b[1] + 0.35 * size * dy];
    const foot = [tip[0] - size * dx, tip[1] - size * dy];
    return [
      tip,
      [foot[0] - half * dy, foot[1] + half * dx],
      [foot[0] + half * dy, foot[1] - half * dx],
    ];
  }

  /** The size of the letters of labels in pixels. */
  const LETTER = 15;

  /** Where a label may stand as seen from its anchor. */
  const SIDES = [
    [0.8, -0.8], [-0.8, -0.8], [0.8, 0.8], [-0.8, 0.8], [1, 0], [-1, 0], [0, -1], [0, 1],
  ];

  /** The area that two boxes [left, top, right, bottom] have in common. */
  function overlap(a, b) {
    const width = Math.min(a[2], b[2]) - Math.max(a[0], b[0]);
    const height = Math.min(a[3], b[3]) - Math.max(a[1], b[1]);
    return Math.max(width, 0) * Math.max(height, 0);
  }

  /**
   * The places of labels, so that they cover neither each other nor dots, and stand away from the
   * middle of the picture where that is possible. `widthOf` measures the text of a label.
   */
  function placeLabels(camera, [width, height], labels, dots, widthOf) {
    const taken = dots.map(({ at, radius }) => {
      const [x, y] = camera.project(at);
      return [x - radius, y - radius, x + radius, y + radius];
    });
    const placed = [];
    // The labels of elements choose before those of axes.
    for (const strong of [true, false]) {
      for (const label of labels) {
        if (label.strong !== strong) continue;
        const at = camera.project(label.at);
        const half = [widthOf(label) / 2, LETTER / 2];
        const away = [at[0] - camera.middle[0], at[1] - camera.middle[1]];
        const candidates = SIDES.map(([x, y]) => {
          const middle = [at[0] + x * (half[0] + 8), at[1] + y * (half[1] + 8)];
          const box = [
            middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1],
          ];
          const outside = box[0] < 2 || box[1] < 2 || box[2] > width - 2 || box[3] > height - 2;
          const covered = taken.reduce((sum, other) => sum + overlap(box, other), 0);
          const cost = covered + (outside ? 1e4 : 0);
          return { middle, box, cost, preference: x * away[0] + y * away[1] };
        });
        candidates.sort((a, b) => a.cost - b.cost || b.preference - a.preference);
        const { middle, box } = candidates[0];
        taken.push(box);
        placed.push({ label, middle });
      }
    }
    return placed;
  }

  /** The middle of a patch. */
  const centreOf = (patch) =>
    scaled(patch.corners.reduce((sum, p) => along(sum, p, 1), [0, 0, 0]), 1 / patch.corners.length);

  return {
    LETTER, TAU, centreOf, clamp, fittedCamera, hiding, outlineCurve, placeLabels, strokes,
  };
})();
