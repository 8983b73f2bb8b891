/**
 * The mathematics of a motion, which needs no document: its camera, its bones, and what is shown at
 * which time. It uses geometry.js. `data` is what ga-draw writes; a pixel is [x, y].
 */
const figure = (() => {
  const { difference, makeCamera, scaled } = geometry;

  /**
   * The camera of a view for a canvas with some place in its middle, which projects place number k
   * of a list of numbers.
   */
  function camera(data, view, [width, height], centre = data.middle) {
    const { azimuth, elevation, zoom } = view;
    const seen = makeCamera({
      azimuth,
      elevation,
      perspective: true,
      axes: data.axes,
      scale: data.scale * zoom * Math.min(width, height),
      middle: [width / 2, height / 2],
    });
    const place = (numbers, k) =>
      scaled(difference(numbers.slice(3 * k, 3 * k + 3), centre), 1 / data.radius);
    return {
      project: (numbers, k) => seen.project(place(numbers, k)),
      depth: (numbers, k) => seen.depth(place(numbers, k)),
    };
  }

  /** The points of a frame as a list of numbers; null where the pose is not known. */
  function pose(data, frame) {
    const index = data.frames[frame];
    const size = 3 * data.names.length;
    return index === null ? null : data.points.slice(index * size, (index + 1) * size);
  }

  /** The place that stays in the middle where a pose is followed: above the mean of its points. */
  function centre(data, points) {
    const mean = (axis) => {
      const numbers = points.filter((_, index) => index % 3 === axis);
      return numbers.reduce((sum, x) => sum + x, 0) / numbers.length;
    };
    return [mean(0), data.middle[1], mean(2)];
  }

  /** The bones of a pose as pairs of pixels with their sides, each after those behind it. */
  function bones(data, camera, points) {
    const parts = data.bones.map(([from, to, side]) => ({
      ends: [camera.project(points, from), camera.project(points, to)],
      depth: camera.depth(points, from) + camera.depth(points, to),
      side,
    }));
    return parts.sort((a, b) => a.depth - b.depth);
  }

  /** The index of the point that is nearest to a pixel within some distance; null for none. */
  function nearest(pixels, [x, y], within) {
    let best = null;
    pixels.forEach((pixel, index) => {
      const distance = Math.hypot(pixel[0] - x, pixel[1] - y);
      if (distance <= within) [best, within] = [index, distance];
    });
    return best;
  }

  /** The frame that is shown some seconds after a frame; the last one from its time on. */
  function frameAfter(data, frame, seconds) {
    // A time that was computed from a frame is that of this frame in spite of rounding.
    const frames = Math.floor(seconds * data.rate + 1e-6);
    return Math.min(Math.max(frame + frames, 0), data.frames.length - 1);
  }

  /** The index of a film's picture for a frame; null where it has none. */
  function pictureAt({ pictures }, frame) {
    let [low, high] = [0, pictures.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (pictures[middle].end <= frame) low = middle + 1;
      else high = middle;
    }
    return low < pictures.length && pictures[low].start <= frame ? low : null;
  }

  return { bones, camera, centre, frameAfter, nearest, pictureAt, pose };
})();
