/** Draws models by WebGL. It uses mesh.js. */
const painters = (() => {
  /** Half the side of the square of floor that may have a shadow, in radii. */
  const SHADOWED = 1.6;
  /** The pixels along a side of it. The shadow is soft, so that few are enough. */
  const SHADOW_SIZE = 128;
  /** Where the grid on the floor ends, in radii from what the camera looks at. */
  const REACH = 2.6;
  const CLAY = [0.8, 0.77, 0.73];
  const SHADERS = {
    model: [
      `attribute vec3 place;
      attribute vec3 normal;
      attribute vec2 coordinates;
      attribute vec3 colour;
      uniform mat4 camera;
      varying vec3 at;
      varying vec3 outward;
      varying vec2 texel;
      varying vec3 paint;
      void main() {
        at = place;
        outward = normal;
        texel = coordinates;
        paint = colour;
        gl_Position = camera * vec4(place, 1.0);
      }`,
      // A key light above the reader's left shoulder, a weak one from the right, light from the sky
      // and from the floor, and a little gloss; light is added in linear numbers.
      `precision mediump float;
      uniform sampler2D picture;
      uniform vec3 eye;
      uniform vec3 key;
      uniform vec3 fill;
      varying highp vec3 at;
      varying vec3 outward;
      varying vec2 texel;
      varying vec3 paint;
      void main() {
        vec3 ray = normalize(eye - at);
        vec3 n = outward;
        n = dot(n, n) < 1e-4 ? ray : normalize(n);
        if (!gl_FrontFacing) n = -n;
        vec3 base = pow(texture2D(picture, texel).rgb * paint, vec3(2.2));
        float above = 0.5 + 0.5 * n.y;
        vec3 light = mix(vec3(0.19, 0.17, 0.155), vec3(0.34, 0.36, 0.39), above);
        light += vec3(0.86, 0.835, 0.79) * max((dot(n, key) + 0.12) / 1.12, 0.0);
        light += vec3(0.09, 0.105, 0.13) * max(dot(n, fill), 0.0);
        float gloss = pow(max(dot(n, normalize(key + ray)), 0.0), 36.0);
        float rim = pow(1.0 - max(dot(n, ray), 0.0), 4.0);
        vec3 seen = base * light + vec3(0.035 * gloss) + vec3(0.05 * rim * above);
        gl_FragColor = vec4(pow(min(seen, 1.0), vec3(1.0 / 2.2)), 1.0);
      }`,
    ],
    // The model from below: near to the floor the shadow is dark.
    below: [
      `attribute vec3 place;
      uniform vec3 target;
      uniform float ground;
      uniform float reach;
      varying float height;
      void main() {
        height = place.y - ground;
        float depth = clamp(height, 0.0, 2.5) * 0.7 - 0.9;
        gl_Position = vec4((place.x - target.x) / reach, (place.z - target.z) / reach, depth, 1.0);
      }`,
      `precision mediump float;
      varying float height;
      void main() {
        float h = max(height, 0.0);
        gl_FragColor = vec4(exp(-14.0 * h), exp(-2.2 * h), 0.0, 1.0);
      }`,
    ],
    // Red, the contact, is blurred less than green, the surroundings.
    blur: [
      `attribute vec3 place;
      varying vec2 texel;
      void main() {
        texel = 0.5 * place.xy + 0.5;
        gl_Position = vec4(place.xy, 0.0, 1.0);
      }`,
      `precision mediump float;
      uniform sampler2D picture;
      uniform vec2 direction;
      varying vec2 texel;
      void main() {
        vec2 sum = vec2(0.0);
        float weights = 0.0;
        for (int k = -5; k <= 5; k++) {
          float x = float(k);
          float weight = exp(-0.12 * x * x);
          sum.r += weight * texture2D(picture, texel + 0.6 * x * direction).r;
          sum.g += weight * texture2D(picture, texel + 2.2 * x * direction).g;
          weights += weight;
        }
        gl_FragColor = vec4(sum / weights, 0.0, 1.0);
      }`,
    ],
    shadow: [
      `attribute vec3 place;
      uniform mat4 camera;
      uniform vec3 target;
      uniform float ground;
      uniform float reach;
      varying vec2 texel;
      void main() {
        texel = 0.5 * place.xy + 0.5;
        vec3 at = vec3(target.x + reach * place.x, ground, target.z + reach * place.y);
        gl_Position = camera * vec4(at, 1.0);
      }`,
      `precision mediump float;
      uniform sampler2D picture;
      varying vec2 texel;
      void main() {
        vec2 dark = texture2D(picture, texel).rg;
        gl_FragColor = vec4(vec3(0.0), 1.0 - (1.0 - 0.55 * dark.r) * (1.0 - 0.38 * dark.g));
      }`,
    ],
    grid: [
      `attribute vec3 place;
      uniform mat4 camera;
      uniform float ground;
      varying vec2 at;
      void main() {
        at = place.xy;
        gl_Position = camera * vec4(place.x, ground, place.y, 1.0);
      }`,
      `precision mediump float;
      uniform vec3 target;
      uniform float reach;
      uniform vec3 ink;
      varying vec2 at;
      void main() {
        float opacity = 0.8 * (1.0 - smoothstep(0.3, 0.95, distance(at, target.xz) / reach));
        gl_FragColor = vec4(ink * opacity, opacity);
      }`,
    ],
  };
  const ATTRIBUTES = ["place", "normal", "coordinates", "colour"];

  /** A program with the places of its uniforms. */
  function link(gl, sources) {
    const program = gl.createProgram();
    [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].forEach((kind, k) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, sources[k]);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
    });
    ATTRIBUTES.forEach((name, index) => gl.bindAttribLocation(program, index, name));
    gl.linkProgram(program);
    const uniforms = new Proxy({}, {
      get: (known, name) => (known[name] ??= gl.getUniformLocation(program, name)),
    });
    return { program, uniforms };
  }

  function makeTexture(gl, wrap, smaller) {
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, wrap);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, wrap);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, smaller);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
    return texture;
  }

  /** What a model is drawn with on a canvas; null without WebGL, or where it lacks long indices. */
  function makePainter(stage, data, model) {
    const gl = stage.getContext("webgl", { antialias: true, preserveDrawingBuffer: true });
    if (!gl || (data.wide && !gl.getExtension("OES_element_index_uint"))) return null;
    const programs = Object.fromEntries(
      Object.entries(SHADERS).map(([name, sources]) => [name, link(gl, sources)]),
    );
    const ground = mesh.floor(data);

    /** A buffer for an attribute, which is filled at once or later. */
    function makeBuffer(numbers, target = gl.ARRAY_BUFFER) {
      const buffer = gl.createBuffer();
      gl.bindBuffer(target, buffer);
      if (numbers) gl.bufferData(target, numbers, gl.STATIC_DRAW);
      return buffer;
    }
    const [places, normals, lines] = [null, null, null].map((none) => makeBuffer(none));
    const square = makeBuffer(new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]));
    const coordinates = data.coordinates && makeBuffer(model.coordinates);
    const colours = data.colours && makeBuffer(model.colours);
    const triangles = makeBuffer(model.triangles, gl.ELEMENT_ARRAY_BUFFER);

    const picture = makeTexture(gl, gl.REPEAT, gl.LINEAR_MIPMAP_LINEAR);
    const pixel = new Uint8Array(data.picture ? [200, 196, 190, 255] : [255, 255, 255, 255]);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    gl.generateMipmap(gl.TEXTURE_2D);

    /** Two pictures of the shadow, each of which is blurred into the other. */
    const shadows = [0, 1].map(() => {
      const texture = makeTexture(gl, gl.CLAMP_TO_EDGE, gl.LINEAR);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, SHADOW_SIZE, SHADOW_SIZE, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
      const frame = gl.createFramebuffer();
      gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
      const depth = gl.createRenderbuffer();
      gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
      gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT16, SHADOW_SIZE, SHADOW_SIZE);
      gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
      return { texture, frame };
    });
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);

    function use({ program, uniforms }) {
      gl.useProgram(program);
      ATTRIBUTES.forEach((_, index) => gl.disableVertexAttribArray(index));
      return uniforms;
    }
    function attribute(name, buffer, size, kind = gl.FLOAT) {
      const index = ATTRIBUTES.indexOf(name);
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.enableVertexAttribArray(index);
      gl.vertexAttribPointer(index, size, kind, kind !== gl.FLOAT, 0, 0);
    }
    function drawTriangles() {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, triangles);
      const kind = data.wide ? gl.UNSIGNED_INT : gl.UNSIGNED_SHORT;
      gl.drawElements(gl.TRIANGLES, model.triangles.length, kind, 0);
    }
    /** Fills the whole picture with the square. */
    function drawSquare() {
      attribute("place", square, 2);
      gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    }

    function drawShadow({ target }) {
      gl.viewport(0, 0, SHADOW_SIZE, SHADOW_SIZE);
      gl.bindFramebuffer(gl.FRAMEBUFFER, shadows[0].frame);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      const below = use(programs.below);
      gl.uniform3fv(below.target, target);
      gl.uniform1f(below.ground, ground);
      gl.uniform1f(below.reach, SHADOWED);
      attribute("place", places, 3);
      drawTriangles();
      gl.disable(gl.DEPTH_TEST);
      const blur = use(programs.blur);
      for (const [from, to] of [[0, 1], [1, 0]]) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, shadows[to].frame);
        gl.bindTexture(gl.TEXTURE_2D, shadows[from].texture);
        gl.uniform2f(blur.direction, (1 - from) / SHADOW_SIZE, from / SHADOW_SIZE);
        drawSquare();
      }
      gl.enable(gl.DEPTH_TEST);
      gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    function drawModel({ matrix, eye, right, upward, toward }) {
      const uniforms = use(programs.model);
      const light = (x, y, z) => {
        const sum = right.map((_, k) => x * right[k] + y * upward[k] + z * toward[k]);
        return sum.map((value) => value / Math.hypot(x, y, z));
      };
      gl.uniformMatrix4fv(uniforms.camera, false, matrix);
      gl.uniform3fv(uniforms.eye, eye);
      gl.uniform3fv(uniforms.key, light(-0.55, 0.7, 0.75));
      gl.uniform3fv(uniforms.fill, light(0.9, 0.1, 0.3));
      gl.bindTexture(gl.TEXTURE_2D, picture);
      attribute("place", places, 3);
      attribute("normal", normals, 3);
      if (coordinates) attribute("coordinates", coordinates, 2);
      if (colours) attribute("colour", colours, 3, gl.UNSIGNED_BYTE);
      else gl.vertexAttrib3fv(ATTRIBUTES.indexOf("colour"), data.picture ? [1, 1, 1] : CLAY);
      drawTriangles();
    }

    /** The floor is transparent, so that it is drawn last. */
    function drawFloor({ matrix, eye, target }, ink) {
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.depthMask(false);
      if (eye[1] > ground) {
        const uniforms = use(programs.shadow);
        gl.uniformMatrix4fv(uniforms.camera, false, matrix);
        gl.uniform3fv(uniforms.target, target);
        gl.uniform1f(uniforms.ground, ground);
        gl.uniform1f(uniforms.reach, SHADOWED);
        gl.bindTexture(gl.TEXTURE_2D, shadows[0].texture);
        drawSquare();
      }
      const uniforms = use(programs.grid);
      gl.uniformMatrix4fv(uniforms.camera, false, matrix);
      gl.uniform3fv(uniforms.target, target);
      gl.uniform1f(uniforms.ground, ground);
      gl.uniform1f(uniforms.reach, REACH);
      gl.uniform3fv(uniforms.ink, ink);
      attribute("place", lines, 2);
      const ends = mesh.grid(data, target, REACH);
      gl.bufferData(gl.ARRAY_BUFFER, ends, gl.DYNAMIC_DRAW);
      gl.drawArrays(gl.LINES, 0, ends.length / 2);
      gl.depthMask(true);
      gl.disable(gl.BLEND);
    }

    /** The frame whose places are in the buffers, and for which the shadow was drawn. */
    let filled = null;
    function fill(frame) {
      const found = mesh.places(data, model, frame);
      const lists = [found, mesh.normals(found, model.corners)];
      [places, normals].forEach((buffer, k) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        gl.bufferData(gl.ARRAY_BUFFER, mesh.ofVertices(lists[k], model), gl.DYNAMIC_DRAW);
      });
      filled = frame;
    }

    /** Draws a frame as it is seen from a view. */
    function paint(view, frame, ink) {
      const { clientWidth: width, clientHeight: height } = stage;
      if (width === 0 || height === 0) return;
      const ratio = Math.min(window.devicePixelRatio || 1, 3);
      const size = [width, height].map((length) => Math.round(length * ratio));
      if (stage.width !== size[0] || stage.height !== size[1]) [stage.width, stage.height] = size;
      const camera = mesh.camera(data, view, [width, height], frame);
      gl.enable(gl.DEPTH_TEST);
      gl.clearColor(0, 0, 0, 0);
      if (filled !== frame) {
        fill(frame);
        if (ground !== null) drawShadow(camera);
      }
      gl.viewport(0, 0, ...size);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      drawModel(camera);
      if (ground !== null) drawFloor(camera, mesh.rgb(ink));
    }

    /** Takes a decoded image as the texture. WebGL repeats only those with powers of two. */
    function setPicture(image) {
      const most = Math.min(gl.getParameter(gl.MAX_TEXTURE_SIZE), 4096);
      const canvas = document.createElement("canvas");
      canvas.width = mesh.textureSize(image.naturalWidth, most);
      canvas.height = mesh.textureSize(image.naturalHeight, most);
      const context = canvas.getContext("2d");
      context.fillStyle = "#c8c4be";
      context.fillRect(0, 0, canvas.width, canvas.height);
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      gl.bindTexture(gl.TEXTURE_2D, picture);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, canvas);
      gl.generateMipmap(gl.TEXTURE_2D);
      const sharp = gl.getExtension("EXT_texture_filter_anisotropic");
      if (sharp) gl.texParameterf(gl.TEXTURE_2D, sharp.TEXTURE_MAX_ANISOTROPY_EXT, 4);
    }

    return { paint, setPicture };
  }

  return { makePainter };
})();
