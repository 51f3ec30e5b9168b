// SPDX-License-Identifier: BSD-3-Clause
// three_water: the scene in three.js, with its Reflector and its Water. Takes its orders from
// three_chromium.py: GET /next waits for a line, POST /answer has the answer.
//
// three.js has y up: (x, y, z) of the scene is (x, z, -y) here. Colours are taken as they are,
// without sRGB, as the other peers do. The multisampling that Reflector has of its own is off. The
// canvas is in no document: the browser would go on to show it while another peer is measured.
import * as THREE from 'three';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { Reflector } from 'three/addons/objects/Reflector.js';
import { Water } from 'three/addons/objects/Water.js';

const WAVES_SIZE = 128; // texels of the normal map
const RMS_SLOPE = 0.05; // of the water, as vtk_water's
// By how much a slope shifts the reflection; three's own 20 is for scenes of some hundred metres.
// With this one waves are seen.
const DISTORTION_SCALE = 300;

async function readScene() {
  const text = await (await fetch('/scene.txt')).text();
  const values = {};
  for (const line of text.trim().split('\n')) {
    const [name, ...rest] = line.split(' ');
    values[name] = rest.map(Number);
  }
  return values;
}

const turned = (x, y, z) => new THREE.Vector3(x, z, -y);

// Slopes of sines that fit into the tile, so that it repeats: a normal map, which Water wants.
// Water adds four of these, each half as strong in slope, and makes the slopes 1.5 times steeper.
function waveNormals() {
  const waves = [[1, 2], [3, -1], [-2, 4]];
  const slope = (RMS_SLOPE / 1.5) * 2 * Math.sqrt(2 / waves.length);
  const texels = new Uint8Array(4 * WAVES_SIZE * WAVES_SIZE);
  for (let row = 0, at = 0; row < WAVES_SIZE; row++) {
    for (let column = 0; column < WAVES_SIZE; column++, at += 4) {
      let x = 0, y = 0;
      for (const [i, j] of waves) {
        const wave = slope * Math.cos(2 * Math.PI * (i * column + j * row) / WAVES_SIZE);
        x += wave * i / Math.hypot(i, j);
        y += wave * j / Math.hypot(i, j);
      }
      texels.set([x, y, 1, 1].map(value => Math.round(127.5 + 127.5 * value)), at);
    }
  }
  const texture = new THREE.DataTexture(texels, WAVES_SIZE, WAVES_SIZE);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

function makeScene(values, geometry, water) {
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(...values.sky);
  // a Lambert surface is divided by pi, which lights are to make good
  const sunColor = new THREE.Color(...values.sun_color);
  const sun = new THREE.DirectionalLight(sunColor, Math.PI * values.diffuse[0]);
  sun.position.copy(turned(...values.to_sun));
  scene.add(sun);
  scene.add(new THREE.AmbientLight(0xffffff, Math.PI * values.ambient[0]));
  scene.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ vertexColors: true })));
  if (water) scene.add(water);
  return scene;
}

function makeWater(values, kind, scale) {
  const [xmin, xmax, ymin, ymax] = values.sheet;
  const geometry = new THREE.PlaneGeometry(xmax - xmin, ymax - ymin);
  const size = { textureWidth: values.size[0] * scale, textureHeight: values.size[1] * scale };
  const water = kind === 'reflector'
    ? new Reflector(geometry, { ...size, multisample: 0 })
    : new Water(geometry, {
      ...size, waterNormals: waveNormals(), sunDirection: turned(...values.to_sun),
      sunColor: new THREE.Color(...values.sun_color), waterColor: new THREE.Color(0.02, 0.07, 0.10),
      distortionScale: DISTORTION_SCALE,
    });
  water.rotation.x = -Math.PI / 2;
  water.position.copy(turned((xmin + xmax) / 2, (ymin + ymax) / 2, 0));
  return water;
}

async function main() {
  THREE.ColorManagement.enabled = false;
  const values = await readScene();
  const renderer = new THREE.WebGLRenderer({ antialias: false, preserveDrawingBuffer: true });
  renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
  renderer.setPixelRatio(1);
  renderer.setSize(...values.size);
  const gl = renderer.getContext();
  const camera = new THREE.PerspectiveCamera(
    values.view_angle[0], values.size[0] / values.size[1], ...values.clipping_range);

  const geometry = await new PLYLoader().loadAsync('/terrain.ply');
  geometry.rotateX(-Math.PI / 2);
  const views = { plain: makeScene(values, geometry) };
  for (const kind of ['reflector', 'water']) {
    views[kind] = makeScene(values, geometry, makeWater(values, kind, 1));
    views[`${kind}-half`] = makeScene(values, geometry, makeWater(values, kind, 0.5));
  }

  const pixel = new Uint8Array(4);
  const render = (view, [ex, ey, ez, tx, ty, tz]) => {
    camera.position.copy(turned(ex, ey, ez));
    camera.lookAt(turned(tx, ty, tz));
    renderer.render(view, camera);
    // waits until all is drawn, which Chromium's finish() does not
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  };
  const answer = text => fetch('/answer', { method: 'POST', body: text });

  const info = gl.getExtension('WEBGL_debug_renderer_info');
  await answer(JSON.stringify({
    variants: Object.keys(views), program: `three.js ${THREE.REVISION}`,
    renderer: gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER),
  }));
  for (;;) {
    const response = await fetch('/next');
    if (response.status !== 200) continue; // nothing yet
    const [what, name, ...rest] = (await response.text()).split(' ');
    const begin = performance.now();
    render(views[name], rest.slice(0, 6).map(Number));
    const took = performance.now() - begin;
    await answer(what === 'picture' ? renderer.domElement.toDataURL('image/png') : took.toFixed(4));
  }
}

main().catch(error => fetch('/answer', { method: 'POST', body: `error ${error.stack || error}` }));
