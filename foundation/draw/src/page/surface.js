/**
 * Balls and patches cut into pieces that can be painted one after the other. It repeats the module
 * surface of ga-draw, whose tests compare the two, and needs no document.
 *
 * A plane is { normal, distance } with the points x for which normal · x = distance. Its positive
 * side is the one that the normal points to.
 */
const surface = (() => {
  const { TAU, along, basisAcross, difference, dot, length, outline, scaled } = geometry;

  /** Scenes with more surfaces than this are not cut, since the number of pieces grows fast. */
  const MOST_CUT = 16;

  const height = (plane, point) => dot(plane.normal, point) - plane.distance;
  const planeOf = (patch) => ({
    normal: patch.normal,
    distance: dot(patch.normal, patch.corners[0]),
  });
  const mean = (points) =>
    scaled(points.reduce((sum, p) => along(sum, p, 1), [0, 0, 0]), 1 / points.length);

  /**
   * The plane of the circle in which two balls meet, with the second ball on its positive side;
   * null where they do not meet.
   */
  function meetingPlane(a, b) {
    const way = difference(b.centre, a.centre);
    const apart = length(way);
    if (a.imaginary || b.imaginary) return null;
    if (apart >= a.radius + b.radius || apart <= Math.abs(a.radius - b.radius)) return null;
    const normal = scaled(way, 1 / apart);
    const t = (apart * apart + a.radius * a.radius - b.radius * b.radius) / (2 * apart);
    return { normal, distance: dot(normal, a.centre) + t };
  }

  /** The circle in which a ball meets a plane. */
  function section(ball, plane) {
    const offset = -height(plane, ball.centre);
    const square = Math.max(ball.radius * ball.radius - offset * offset, 0);
    return {
      centre: along(ball.centre, plane.normal, offset),
      basis: basisAcross(plane.normal),
      radius: Math.sqrt(square),
    };
  }

  /** The pixels of a circle from one angle to another. */
  function arc({ centre, basis: [u, v], radius }, from, to, camera) {
    const count = Math.max(Math.ceil((Math.abs(to - from) * 96) / TAU), 2);
    const points = [];
    for (let k = 0; k <= count; k++) {
      const angle = from + ((to - from) * k) / count;
      const point = along(along(centre, u, radius * Math.cos(angle)), v, radius * Math.sin(angle));
      points.push(camera.project(point));
    }
    return points;
  }

  /** The angle of the middle of the part of a circle on the positive side, and half its angle. */
  function positiveArc({ centre, basis, radius }, plane) {
    const [a, b] = basis.map((axis) => dot(plane.normal, axis) * radius);
    const needed = -height(plane, centre);
    const reach = Math.hypot(a, b);
    const half = reach > Math.abs(needed) ? Math.acos(needed / reach) : needed < 0 ? Math.PI : 0;
    return [Math.atan2(b, a), half];
  }

  /** The part of the picture where the front of a ball is on one side of a plane. */
  function region(ball, plane, positive, camera) {
    const horizon = camera.horizon(ball);
    const [rim, cut] = [section(ball, horizon), section(ball, plane)];
    const [rimMiddle, rimHalf] = positiveArc(rim, plane);
    const [cutMiddle, cutHalf] = positiveArc(cut, horizon);
    const isWhole = (half) => half === 0 || half === Math.PI;
    if (isWhole(cutHalf) || isWhole(rimHalf)) {
      // The two circles do not cross: the outline is on one side.
      const parts = [];
      if (rimHalf > 0.5 * Math.PI === positive) parts.push(arc(rim, 0, TAU, camera));
      if (cutHalf > 0.5 * Math.PI) parts.push(arc(cut, 0, TAU, camera));
      return parts;
    }
    const path = positive
      ? arc(rim, rimMiddle - rimHalf, rimMiddle + rimHalf, camera)
      : arc(rim, rimMiddle + rimHalf, rimMiddle + TAU - rimHalf, camera);
    const back = arc(cut, cutMiddle - cutHalf, cutMiddle + cutHalf, camera);
    const gap = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);
    const last = path[path.length - 1];
    if (gap(last, back[0]) > gap(last, back[back.length - 1])) back.reverse();
    return [path.concat(back)];
  }

  /** The part of a convex polygon on one side of a plane. */
  function kept(polygon, plane, positive) {
    const heights = polygon.map((point) => (positive ? 1 : -1) * height(plane, point));
    const part = [];
    polygon.forEach((from, k) => {
      const next = (k + 1) % polygon.length;
      const [a, b] = [heights[k], heights[next]];
      if (a >= 0) part.push(from);
      if ((a > 1e-9 && b < -1e-9) || (a < -1e-9 && b > 1e-9)) {
        part.push(along(from, difference(polygon[next], from), a / (a - b)));
      }
    });
    // A polygon in the plane itself counts as on its positive side only.
    const isReal = heights.some((h) => h > 1e-9) || (positive && part.length === polygon.length);
    return isReal ? part : [];
  }

  /** The pieces of a patch, cut by the planes of the other patches. */
  function cutPatch(patch, patches, cuts, camera) {
    let polygons = [patch.corners];
    for (const other of cuts ? patches : []) {
      if (other === patch) continue;
      const plane = planeOf(other);
      polygons = polygons
        .flatMap((polygon) => [true, false].map((side) => kept(polygon, plane, side)))
        .filter((polygon) => polygon.length > 2);
    }
    return polygons.map((polygon) => ({
      patch,
      polygon,
      sides: [],
      regions: [[polygon.map(camera.project)]],
      depth: camera.depth(mean(polygon)),
    }));
  }

  /** Whether any part of a piece of a ball faces the eye, sampled at 400 points of the ball. */
  function isVisible(ball, piece, camera) {
    const horizon = camera.horizon(ball);
    const golden = Math.PI * (3 - Math.sqrt(5));
    for (let sample = 0; sample < 400; sample++) {
      const z = 1 - (2 * (sample + 0.5)) / 400;
      const across = Math.sqrt(1 - z * z);
      const angle = golden * sample;
      const side = [across * Math.cos(angle), across * Math.sin(angle), z];
      const point = along(ball.centre, side, ball.radius);
      const within = ({ plane, side }) => height(plane, point) > 0 === side;
      if (height(horizon, point) >= 0 && piece.sides.every(within)) return true;
    }
    return false;
  }

  /**
   * The pieces of a ball, cut by the planes of patches and of circles in which it meets other
   * balls.
   */
  function cutBall(ball, balls, patches, cuts, camera) {
    const whole = {
      ball,
      sides: [],
      regions: [[outline(camera, ball).map(camera.project)]],
      depth: camera.depth(ball.centre),
    };
    if (!cuts) return [whole];
    const cutters = patches.map((other) => ({ other, plane: planeOf(other) }));
    for (const other of balls) {
      const plane = other === ball ? null : meetingPlane(ball, other);
      if (plane) cutters.push({ other, plane });
    }
    const crossing = [];
    for (const { other, plane } of cutters) {
      const offset = height(plane, ball.centre);
      if (Math.abs(offset) < 0.999 * ball.radius) crossing.push({ other, plane });
      else whole.sides.push({ other, plane, side: offset > 0 });
    }
    let parts = [whole];
    for (const { other, plane } of crossing) {
      parts = parts
        .flatMap((part) =>
          [true, false].map((side) => ({
            ...part,
            sides: part.sides.concat([{ other, plane, side }]),
            regions: part.regions.concat([region(ball, plane, side, camera)]),
          })),
        )
        .filter((part) => isVisible(ball, part, camera));
    }
    return parts;
  }

  /** The box around what a piece covers: left, top, right, bottom. */
  function bounds(piece) {
    const box = [-Infinity, -Infinity, Infinity, Infinity];
    for (const region of piece.regions) {
      const own = [Infinity, Infinity, -Infinity, -Infinity];
      for (const [x, y] of region.flat()) {
        own[0] = Math.min(own[0], x);
        own[1] = Math.min(own[1], y);
        own[2] = Math.max(own[2], x);
        own[3] = Math.max(own[3], y);
      }
      for (const k of [0, 1]) {
        box[k] = Math.max(box[k], own[k]);
        box[k + 2] = Math.min(box[k + 2], own[k + 2]);
      }
    }
    return box;
  }

  /** The side of a plane of another surface on which a piece of a ball lies, if it cuts the ball. */
  const sideOf = (piece, other) => piece.sides.find((side) => side.other === other)?.side;

  function ballHidesPatch(piece, patch, camera) {
    const plane = planeOf(patch);
    const side = sideOf(piece, patch) ?? height(plane, piece.ball.centre) > 0;
    return side === camera.isAbove(plane);
  }

  function ballHidesBall(a, b, camera) {
    const way = difference(b.ball.centre, a.ball.centre);
    const apart = length(way);
    // The front of the outer ball is in front of the inner ball.
    if (apart <= Math.abs(a.ball.radius - b.ball.radius)) return a.ball.radius > b.ball.radius;
    const plane = meetingPlane(a.ball, b.ball);
    if (!plane) {
      // The plane half way between the surfaces.
      const normal = scaled(way, 1 / apart);
      const gap = apart - a.ball.radius - b.ball.radius;
      const distance = dot(normal, a.ball.centre) + a.ball.radius + 0.5 * gap;
      return !camera.isAbove({ normal, distance });
    }
    // The positive side of the plane as seen from a is that of b. The part within the other ball
    // is behind its surface.
    const [aWithin, bWithin] = [sideOf(a, b.ball) ?? false, sideOf(b, a.ball) ?? false];
    return aWithin || bWithin ? !aWithin : !camera.isAbove(plane);
  }

  /** Whether the first piece hides the second where they overlap; null where neither does. */
  function hides(a, b, camera) {
    if (a.patch && b.patch) {
      if (a.patch === b.patch) return null;
      const plane = planeOf(b.patch);
      const offset = height(plane, mean(a.polygon));
      return Math.abs(offset) > 1e-9 ? offset > 0 === camera.isAbove(plane) : null;
    }
    if (a.ball && b.patch) return ballHidesPatch(a, b.patch, camera);
    if (a.patch) return !ballHidesPatch(b, a.patch, camera);
    return a.ball === b.ball ? null : ballHidesBall(a, b, camera);
  }

  /**
   * Sorts so that each piece comes after those that it hides; where these relations form a cycle,
   * by depth.
   */
  function sorted(pieces, camera) {
    const boxes = pieces.map(bounds);
    const overlap = (a, b) =>
      [0, 1].every((k) => boxes[a][k] <= boxes[b][k + 2] && boxes[b][k] <= boxes[a][k + 2]);
    // For each piece, how many others must still come before it, and which come after it.
    const before = pieces.map(() => 0);
    const after = pieces.map(() => []);
    for (let a = 0; a < pieces.length; a++) {
      for (let b = a + 1; b < pieces.length; b++) {
        const answer = overlap(a, b) ? hides(pieces[a], pieces[b], camera) : null;
        if (answer === null) continue;
        const [first, second] = answer ? [b, a] : [a, b];
        before[second]++;
        after[first].push(second);
      }
    }
    const rest = pieces.map((_, k) => k).sort((a, b) => pieces[a].depth - pieces[b].depth);
    const order = [];
    while (rest.length) {
      const [piece] = rest.splice(Math.max(rest.findIndex((k) => before[k] === 0), 0), 1);
      for (const later of after[piece]) before[later]--;
      order.push(pieces[piece]);
    }
    return order;
  }

  /** The pieces of all balls and patches in the order in which they are to be painted. */
  function pieces(camera, balls, patches) {
    const cuts = balls.length + patches.length <= MOST_CUT;
    const parts = patches.flatMap((patch) => cutPatch(patch, patches, cuts, camera));
    return sorted(
      parts.concat(balls.flatMap((ball) => cutBall(ball, balls, patches, cuts, camera))),
      camera,
    );
  }

  return { pieces };
})();
