/**
 * A canvas that fits its place on a page, and whose view the pointer, the wheel and the keys
 * change. It uses geometry.js.
 */
const stages = (() => {
  const { clamp } = geometry;

  /** Fits a canvas to its place on the page, and clears it; gives its width and height. */
  function cleared(stage, context) {
    const { clientWidth: width, clientHeight: height } = stage;
    const ratio = window.devicePixelRatio || 1;
    const [wide, high] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (stage.width !== wide || stage.height !== high) [stage.width, stage.height] = [wide, high];
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    return [width, height];
  }

  /** The action, put off until the page is painted next, however often it is asked for. */
  function oncePerPainting(action) {
    let waiting = false;
    return () => {
      if (waiting) return;
      waiting = true;
      requestAnimationFrame(() => {
        waiting = false;
        action();
      });
    };
  }

  /**
   * Changes `view`, an object with azimuth, elevation and zoom, as the reader asks for it on the
   * canvas, and calls `redraw` after each change. `start` is the view to which the reader returns.
   */
  function turntable(stage, view, start, redraw) {
    function rotate(azimuth, elevation) {
      view.azimuth = (view.azimuth + azimuth) % 360;
      view.elevation = clamp(view.elevation + elevation, -90, 90);
      redraw();
    }
    function zoom(factor) {
      view.zoom = clamp(view.zoom * factor, 0.1, 20);
      redraw();
    }
    function reset() {
      Object.assign(view, start);
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
      if (fingers.size === 1) rotate(-0.4 * (event.clientX - last[0]), 0.4 * (event.clientY - last[1]));
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
      ArrowLeft: () => rotate(5, 0),
      ArrowRight: () => rotate(-5, 0),
      ArrowUp: () => rotate(0, 5),
      ArrowDown: () => rotate(0, -5),
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
  }

  return { cleared, oncePerPainting, turntable };
})();
