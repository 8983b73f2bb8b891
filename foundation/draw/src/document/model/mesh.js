/**
 * The mathematics of a model, which needs no document and no WebGL: what its data say, its normals,
 * its camera, and what is shown at which time. It uses geometry.js. `data` is what ga-draw writes.
 *
 * Places are in radii of the model, from what the camera looks at in the first frame.
 */
const mesh = (() => {
  const { EYE, clamp, dot, makeCamera } = geometry;
  /** The distances from the eye between which something is shown; floors reach far. */
  const [NEAR, FAR] = [0.4, 12];
  /** The part of the canvas that the model fills. */
  const FILLING = 0.9;
  /** The least breadth for which the model is enlarged, in radii. */
  const LEAST_ACROSS = 0.4;
  const AXES = [[0, 0, 1], [1, 0, 0], [0, 1, 0]];

  function bytes(base64) {
    const text = atob(base64);
    const numbers = new Uint8Array(text.length);
    for (let k = 0; k < text.length; k++) numbers[k] = text.charCodeAt(k);
    return numbers;
  }

  /** The lists of numbers of the data. Every browser's machine has the lowest byte first. */
  function decode(data) {
    const list = (Kind, base64) => (base64 === null ? null : new Kind(bytes(base64).buffer));
    const Index = data.wide ? Uint32Array : Uint16Array;
    const points = list(Uint16Array, data.points.numbers);
    const count = points.length / 3 / data.frames;
    const sources = list(Index, data.sources) ?? Index.from({ length: count }, (_, k) => k);
    const triangles = list(Index, data.triangles);
    const coordinates = data.coordinates && scaled(list(Uint16Array, data.coordinates.numbers), data.coordinates);
    return {
      points,
      count,
      sources,
      triangles,
      corners: triangles.map((vertex) => sources[vertex]),
      coordinates,
      colours: list(Uint8Array, data.colours),
    };
  }

  /** The numbers that whole numbers along two or three axes stand for. */
  function scaled(numbers, { low, step }) {
    const axes = low.length;
    return Float32Array.from(numbers, (n, k) => low[k % axes] + n * step[k % axes]);
  }

  /** What the camera looks at in a frame, in metres. */
  const centre = ({ centres }, frame) => centres[Math.min(frame, centres.length - 1)];

  /** The same as a place. */
  const target = (data, frame) =>
    centre(data, frame).map((x, k) => (x - centre(data, 0)[k]) / data.radius);

  /** The height of the floor as that of a place; null for none. */
  const floor = (data) =>
    data.floor === null ? null : (data.floor - centre(data, 0)[1]) / data.radius;

  /** The places of all points in a frame. */
  function places(data, { points, count }, frame) {
    const { low, step } = data.points;
    const start = centre(data, 0);
    const from = 3 * count * frame;
    const found = new Float32Array(3 * count);
    for (let k = 0; k < found.length; k++) {
      const axis = k % 3;
      found[k] = (low[axis] + points[from + k] * step[axis] - start[axis]) / data.radius;
    }
    return found;
  }

  /**
   * The normal of each point: the sum of those of its triangles, each with the length of twice the
   * triangle's area, so that small triangles beside large ones do not bend the surface.
   */
  function normals(places, corners) {
    const sums = new Float32Array(places.length);
    for (let k = 0; k < corners.length; k += 3) {
      const [a, b, c] = [3 * corners[k], 3 * corners[k + 1], 3 * corners[k + 2]];
      const [ux, uy, uz] = [places[b] - places[a], places[b + 1] - places[a + 1], places[b + 2] - places[a + 2]];
      const [vx, vy, vz] = [places[c] - places[a], places[c + 1] - places[a + 1], places[c + 2] - places[a + 2]];
      const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
      for (const at of [a, b, c]) {
        sums[at] += x;
        sums[at + 1] += y;
        sums[at + 2] += z;
      }
    }
    for (let k = 0; k < sums.length; k += 3) {
      // Where sheets lie on each other there is no normal.
      const length = Math.hypot(sums[k], sums[k + 1], sums[k + 2]) || 1;
      sums[k] /= length;
      sums[k + 1] /= length;
      sums[k + 2] /= length;
    }
    return sums;
  }

  /** Three numbers of each vertex from those of the points, one list after the other. */
  function ofVertices(numbers, { sources }) {
    const found = new Float32Array(3 * sources.length);
    for (let k = 0; k < sources.length; k++) {
      const [to, from] = [3 * k, 3 * sources[k]];
      found[to] = numbers[from];
      found[to + 1] = numbers[from + 1];
      found[to + 2] = numbers[from + 2];
    }
    return found;
  }

  /**
   * Where the middle of the view is on the canvas after its zoom has changed by a factor, so that
   * what is at `pointer` stays there. Both are [x, y] from −1 to 1, x to the right and y up. A model
   * that fits into the canvas stays in the middle.
   */
  function shifted(shift, pointer, factor, zoom) {
    const most = Math.max(zoom - 1, 0);
    return shift.map((at, k) => clamp(pointer[k] + (at - pointer[k]) * factor, -most, most));
  }

  /**
   * The camera of a view in a frame, for a canvas of some size, as WebGL needs it. What it looks at
   * is at `view.shift` on the canvas.
   */
  function camera(data, view, [width, height], frame) {
    const breadth = Math.max(data.across, LEAST_ACROSS);
    const { right, upward, toward, scale } = makeCamera({
      azimuth: view.azimuth,
      elevation: view.elevation,
      perspective: true,
      axes: AXES,
      scale: (FILLING / 2) * view.zoom * Math.min(width / breadth, height),
      middle: [width / 2, height / 2],
    });
    const looked = target(data, frame);
    const [x, y] = [width, height].map((size) => (2 * scale * EYE) / size);
    const [slope, offset] = [(FAR + NEAR) / (FAR - NEAR), (2 * FAR * NEAR) / (FAR - NEAR)];
    // The distance of a place from the eye along the view is `away` − dot(place, toward).
    const away = EYE + dot(looked, toward);
    const matrix = new Float32Array(16);
    const [dx, dy] = view.shift;
    for (let k = 0; k < 3; k++) {
      const [across, up] = [x * right[k] - dx * toward[k], y * upward[k] - dy * toward[k]];
      matrix.set([across, up, -slope * toward[k], -toward[k]], 4 * k);
    }
    const start = [dx * away - x * dot(looked, right), dy * away - y * dot(looked, upward)];
    matrix.set([...start, slope * away - offset, away], 12);
    const eye = looked.map((at, k) => at + EYE * toward[k]);
    return { matrix, eye, target: looked, right, upward, toward };
  }

  /** The ends x, z of the lines on the floor that are within some reach of a target. */
  function grid(data, [x, , z], reach) {
    const start = centre(data, 0);
    const size = data.square / data.radius;
    const lines = [];
    for (const [along, across, axis] of [[x, z, 0], [z, x, 2]]) {
      // Lines are at multiples of the squares' sides from the origin of the model's coordinates.
      const origin = -start[axis] / data.radius;
      const first = Math.ceil((along - reach - origin) / size);
      for (let k = first; origin + k * size <= along + reach; k++) {
        const at = origin + k * size;
        const ends = [[at, across - reach], [at, across + reach]];
        for (const [a, b] of ends) lines.push(...(axis === 0 ? [a, b] : [b, a]));
      }
    }
    return new Float32Array(lines);
  }

  /** The frame some seconds after a frame; the first one follows the last. */
  function frameAfter(data, frame, seconds) {
    // A time that was computed from a frame is that of this frame in spite of rounding.
    return (frame + Math.floor(Math.max(seconds, 0) * data.rate + 1e-6)) % data.frames;
  }

  /** Red, green and blue from 0 to 1 of a colour such as #0072b2. */
  const rgb = (hex) => [1, 3, 5].map((k) => clamp(parseInt(hex.slice(k, k + 2), 16) / 255 || 0, 0, 1));

  /** The size in which a texture is repeated and made smaller: powers of two up to a limit. */
  const textureSize = (size, most) => Math.min(2 ** Math.ceil(Math.log2(Math.max(size, 1))), most);

  return { camera, decode, floor, frameAfter, grid, normals, ofVertices, places, rgb, shifted, textureSize };
})();
