"use strict";
/**
 * The mathematics of the page: the camera, what hides what, and the places of labels. It needs no
 * document. It repeats the modules camera, stroke and label of ga-draw, whose tests compare the
 * two; surface.js repeats the module surface.
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
    /** Whether the eye is on the positive side of a plane { normal, distance }. */
    const isAbove = ({ normal, distance }) =>
      perspective ? EYE * dot(normal, toward) > distance : dot(normal, toward) > 0;
    /** The plane through the outline of a ball, with the visible part on its positive side. */
    const horizon = ({ centre, radius }) => {
      const [normal, distance] = ray(centre);
      // The plane is the polar plane of the eye. For parallel rays r²/∞ is zero.
      const height = Math.min((radius * radius) / distance, 0.999 * radius);
      return { normal, distance: dot(normal, centre) + height };
    };
    return { depth, ray, project, isAbove, horizon, scale, middle, right, upward, toward };
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

  /** The gaps between a label and its anchor that are tried, in pixels. */
  const GAPS = [8, 24, 44, 68];
  /** What each further gap counts for, as covered pixels. */
  const RING_COST = 12;
  /** What each point of a line under a label counts for, as covered pixels. */
  const LINE_COST = 8;
  /** The opacity of lines from which on labels avoid them. */
  const FAINTEST = 0.7;
  /** How often all labels are placed anew. */
  const ROUNDS = 2;
  /** The distance of labels from the edge of the picture. */
  const EDGE = 3;
  /** The distance from which on a line joins a label to its anchor. */
  const LEADER = 16;

  /**
   * The area that a box covers of others, and what points of lines under it and the distance of its
   * label count for.
   */
  function labelCost({ box, ring }, lines, taken) {
    const covered = taken.reduce((sum, other) => sum + overlap(box, other), 0);
    let under = 0;
    for (const [x, y] of lines) {
      if (box[0] <= x && x <= box[2] && box[1] <= y && y <= box[3]) under++;
    }
    return covered + LINE_COST * under + RING_COST * ring;
  }

  /** The best place for one label of a given half width. */
  function placeLabel(camera, size, label, halfWidth, lines, taken) {
    const at = camera.project(label.at);
    const half = [halfWidth, LETTER / 2];
    const away = [at[0] - camera.middle[0], at[1] - camera.middle[1]];
    const preference = ([x, y]) => x * away[0] + y * away[1];
    const sides = [...SIDES].sort((a, b) => preference(b) - preference(a));
    let best = null;
    GAPS.forEach((gap, ring) => {
      for (const side of sides) {
        const middle = [0, 1].map((k) => {
          const margin = half[k] + EDGE;
          const wish = at[k] + side[k] * (half[k] + gap);
          return Math.max(Math.min(wish, size[k] - margin), margin);
        });
        const box = [
          middle[0] - half[0], middle[1] - half[1], middle[0] + half[0], middle[1] + half[1],
        ];
        const place = { label, halfWidth, middle, box, ring, at };
        const cost = labelCost(place, lines, taken);
        if (!best || cost < best.cost) best = { cost, place };
      }
    });
    return best.place;
  }

  /** The line from the box of a label that stands far from its anchor to the anchor, or null. */
  function leader({ box, at }) {
    const near = [0, 1].map((k) => clamp(at[k], box[k], box[k + 2]));
    return Math.hypot(near[0] - at[0], near[1] - at[1]) > LEADER ? [near, at] : null;
  }

  /**
   * The places of labels, so that they are inside the picture, cover neither each other nor dots,
   * nor lines where possible, and stand away from the middle of the picture where that is possible. `widthOf` measures the
   * text of a label.
   */
  function placeLabels(camera, size, { labels, dots, curves }, widthOf) {
    const taken = dots.map(({ at, radius }) => {
      const [x, y] = camera.project(at);
      return [x - radius, y - radius, x + radius, y + radius];
    });
    const fixed = taken.length;
    const lines = curves
      .filter((curve) => curve.opacity > FAINTEST)
      .flatMap((curve) => curve.points.map(camera.project));
    // The labels of elements are placed before those of axes.
    const order = [true, false].flatMap((strong) => labels.filter((l) => l.strong === strong));
    const placed = order.map((label) => {
      const place = placeLabel(camera, size, label, widthOf(label) / 2, lines, taken);
      taken.push(place.box);
      return place;
    });
    // Early labels were placed before the later ones were there.
    for (let round = 0; round < ROUNDS; round++) {
      placed.forEach((old, k) => {
        const others = taken.filter((_, index) => index !== fixed + k);
        const place = placeLabel(camera, size, old.label, old.halfWidth, lines, others);
        if (labelCost(place, lines, others) < labelCost(old, lines, others)) {
          placed[k] = place;
          taken[fixed + k] = place.box;
        }
      });
    }
    return placed.map((place) => ({ ...place, leader: leader(place) }));
  }

  return {
    EYE, LETTER, TAU, along, basisAcross, clamp, difference, dot, fittedCamera, hiding, length,
    makeCamera, outline, outlineCurve, placeLabels, scaled, strokes,
  };
})();
