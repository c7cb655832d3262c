// A view of voxels that can be turned: cubes in plain WebGL 2, coloured by light or by facet, and the
// wave of light as it spreads. The page's data are in `scenes`: {name: {n, count, step, voxels, facets,
// lights, sources}}, arrays in base64.
"use strict";

function bytes(text, Type) {
  const raw = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  return new Type(raw.buffer);
}

const VERTEX = `#version 300 es
in vec3 corner, normal, voxel;
in float facet, light, away;
uniform mat4 view;
uniform float n, wave;
uniform int paint;
out vec3 colour;
vec3 hue(float h) { return clamp(abs(fract(h + vec3(0., 2., 1.) / 3.) * 6. - 3.) - 1., 0., 1.); }
void main() {
  float shade = 0.72 + 0.28 * dot(normal, vec3(0.36, 0.48, 0.8));
  float lit = away <= wave ? light : 0.;
  vec3 own = mix(vec3(0.75), hue(fract(facet * 0.61803398875)), 0.7);
  vec3 warm = mix(vec3(0.17, 0.19, 0.28), vec3(1., 0.93, 0.76), lit > 0. ? 0.55 + 0.45 * lit : 0.);
  colour = (paint == 0 ? warm : paint == 1 ? own : own * (lit > 0. ? 1. : 0.25)) * shade;
  if (abs(away - wave) < 1. && light > 0.) colour = vec3(1., 0.6, 0.1);
  gl_Position = view * vec4((voxel + corner - 0.5 * (n - 1.)) / (0.5 * n), 1.);
}`;
const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 colour;
out vec4 pixel;
void main() { pixel = vec4(colour, 1.); }`;

// Two triangles for each side of a cube, with its normal.
function cube() {
  const data = [];
  for (let axis = 0; axis < 3; ++axis)
    for (const side of [-1, 1])
      for (const [u, v] of [[-1, -1], [1, -1], [1, 1], [-1, -1], [1, 1], [-1, 1]]) {
        const corner = [0, 0, 0], normal = [0, 0, 0];
        corner[axis] = side / 2;
        corner[(axis + 1) % 3] = u / 2;
        corner[(axis + 2) % 3] = (side * v) / 2;
        normal[axis] = side;
        data.push(...corner, ...normal);
      }
  return new Float32Array(data);
}

// Column by column: a turn about y, then about x, then a perspective.
function viewMatrix(turn, tilt, distance, aspect) {
  const [cy, sy, cx, sx] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
  const f = 3.6, near = 0.1, far = 30, a = (far + near) / (near - far), b = (2 * far * near) / (near - far);
  const rows = [[cy, 0, sy, 0], [sx * sy, cx, -sx * cy, 0], [-cx * sy, sx, cx * cy, -distance]];
  const out = [];
  for (let k = 0; k < 4; ++k)
    out.push((f / aspect) * rows[0][k], f * rows[1][k], a * rows[2][k] + (k === 3 ? b : 0), -rows[2][k]);
  return new Float32Array(out);
}

class View {
  constructor(canvas) {
    const gl = (this.gl = canvas.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true }));
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.canvas = canvas;
    this.program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, FRAGMENT]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(this.program));
    gl.useProgram(this.program);
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    this.attribute(["corner", 3, 24, 0], ["normal", 3, 24, 12], cube(), 0);
    Object.assign(this, { turn: -0.4, tilt: 0.3, distance: 6.5, paint: 0, wave: 1e9, lamp: 0 });
    this.listen();
  }

  // The last two arguments: the data, and 1 if they step once a cube instead of once a corner.
  attribute(...words) {
    const gl = this.gl, divisor = words.pop(), data = words.pop();
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    for (const [name, size, stride, offset] of words) {
      const at = gl.getAttribLocation(this.program, name);
      if (at < 0) continue;
      gl.enableVertexAttribArray(at);
      gl.vertexAttribPointer(at, size, gl.FLOAT, false, stride, offset);
      gl.vertexAttribDivisor(at, divisor);
    }
  }

  show(scene) {
    this.scene = scene;
    const voxels = bytes(scene.voxels, Uint8Array);
    this.attribute(["voxel", 3, 0, 0], Float32Array.from(voxels), 1);
    this.attribute(["facet", 1, 0, 0], Float32Array.from(bytes(scene.facets, Uint32Array)), 1);
    this.choose(Math.min(this.lamp, scene.sources.length - 1));
  }

  choose(lamp) {
    this.lamp = lamp;
    const { scene } = this, source = scene.sources[lamp].voxel, voxels = bytes(scene.voxels, Uint8Array);
    const away = new Float32Array(scene.count);
    for (let i = 0; i < scene.count; ++i)
      for (let k = 0; k < 3; ++k) away[i] = Math.max(away[i], Math.abs(voxels[3 * i + k] - source[k]));
    this.attribute(["away", 1, 0, 0], away, 1);
    this.attribute(["light", 1, 0, 0], Float32Array.from(bytes(scene.lights[lamp], Uint8Array), (v) => v / 255), 1);
    this.draw();
  }

  draw() {
    const { gl, canvas, scene } = this, at = (name) => gl.getUniformLocation(this.program, name);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clearColor(0.035, 0.04, 0.06, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.uniformMatrix4fv(at("view"), false, viewMatrix(this.turn, this.tilt, this.distance, canvas.width / canvas.height));
    gl.uniform1f(at("n"), scene.n);
    gl.uniform1f(at("wave"), this.wave);
    gl.uniform1i(at("paint"), this.paint);
    gl.drawArraysInstanced(gl.TRIANGLES, 0, 36, scene.count);
  }

  // Pixels that are not background.
  drawn() {
    const { gl, canvas } = this, pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) count += pixels[i] > 12 || pixels[i + 1] > 13 || pixels[i + 2] > 18;
    return count;
  }

  listen() {
    let from = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointerup", () => (from = null));
    this.canvas.addEventListener("pointermove", (event) => {
      if (!from) return;
      this.turn += (event.clientX - from[0]) / 150;
      this.tilt = Math.max(-1.5, Math.min(1.5, this.tilt + (event.clientY - from[1]) / 150));
      from = [event.clientX, event.clientY];
      this.draw();
    });
    this.canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.distance = Math.max(2.5, Math.min(20, this.distance * Math.exp(event.deltaY / 800)));
      this.draw();
    }, { passive: false });
  }
}

// The controls beside the canvas, and what a script that opens the page reads: data-pixels of the body.
function start(scenes) {
  const get = (id) => document.getElementById(id);
  const view = new View(get("view")), names = Object.keys(scenes);
  let playing = null;
  const wave = get("wave"), cycles = get("cycles");
  const tell = () => {
    const { scene } = view, k = Number(wave.value), all = k >= wave.max;
    view.wave = all ? 1e9 : k;
    cycles.textContent = all ? `all of it: ${scene.sources[view.lamp].cycles} cycles` : `step ${k}: cycle ${scene.step * k}`;
    view.draw();
  };
  const refill = () => {
    const { sources, n } = view.scene;
    get("lamp").replaceChildren(...sources.map((source, k) => new Option(`light ${k} at ${source.voxel.join(", ")}`, k)));
    get("lamp").value = view.lamp;
    wave.max = Math.max(...sources[view.lamp].voxel.map((v) => Math.max(v, n - 1 - v))) + 1;
    wave.value = wave.max;
    tell();
  };
  get("scene").replaceChildren(...names.map((name) => new Option(name)));
  get("scene").onchange = () => (view.show(scenes[get("scene").value]), refill());
  get("lamp").onchange = () => (view.choose(Number(get("lamp").value)), refill());
  get("paint").onchange = () => ((view.paint = Number(get("paint").value)), view.draw());
  wave.oninput = tell;
  get("play").onclick = () => {
    clearInterval(playing);
    wave.value = 0;
    playing = setInterval(() => {
      wave.value = Number(wave.value) + 1;
      tell();
      if (Number(wave.value) >= Number(wave.max)) clearInterval(playing);
    }, 60);
  };
  view.show(scenes[names[0]]);
  refill();
  document.body.dataset.pixels = view.drawn();
  wave.value = Math.round(wave.max / 2);
  tell();
  document.body.dataset.waving = view.drawn();
  wave.value = wave.max;
  tell();
  return view;
}
