// Runs the mathematics of the page on the cases that stand as JSON on standard input, and writes
// what it finds as JSON.
const fs = require("node:fs");
const { source, cases } = JSON.parse(fs.readFileSync(0, "utf8"));
const { geometry, surface } = new Function(`${source}\nreturn { geometry, surface };`)();
const { fittedCamera, hiding, outlineCurve, placeLabels, strokes } = geometry;

const answers = cases.map(({ data, size, points, widths }) => {
  const { picture } = data;
  const camera = fittedCamera(data, data, size);
  const isHidden = hiding(camera, picture.balls, picture.patches, 0.02);
  const outlines = picture.balls.map((ball) => outlineCurve(camera, ball));
  const curves = picture.curves.concat(outlines).map((curve) =>
    strokes(camera, curve, isHidden).map(({ points, hidden, depth, head }) => ({
      hidden,
      depth,
      first: camera.project(points[0]),
      last: camera.project(points[points.length - 1]),
      head: head ?? null,
    })),
  );
  const widthOf = (label) => widths[picture.labels.indexOf(label)];
  const labels = placeLabels(camera, size, picture, widthOf);
  const pieces = surface.pieces(camera, picture.balls, picture.patches);
  return {
    pieces: pieces.map(({ ball, patch, sides, regions }) => ({
      ball: ball ? picture.balls.indexOf(ball) : null,
      patch: patch ? picture.patches.indexOf(patch) : null,
      sides: sides.map(({ side }) => side),
      regions,
    })),
    scale: camera.scale,
    middle: camera.middle,
    projected: points.map(camera.project),
    depths: points.map(camera.depth),
    hidden: points.map(isHidden),
    curves,
    labels: labels.map(({ label, middle, leader }) => ({
      index: picture.labels.indexOf(label),
      middle,
      leader,
    })),
  };
});
process.stdout.write(JSON.stringify(answers));
