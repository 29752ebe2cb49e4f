// node pictures.mjs PROGRAM EXAMPLES FIGURES: pictures of pages and bodies, as a headless Chromium shows them.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const [program, examples, figures] = process.argv.slice(2);
const modules = join(dirname(fileURLToPath(import.meta.url)), 'node_modules');
const folder = mkdtempSync(join(tmpdir(), 'phrame-pictures-'));
const run = (...words) => execFileSync(program, words);

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  chromiumSandbox: process.getuid() !== 0,
  args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});

/** The scene of a page. */
async function scene(file, width, height) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
  await page.goto(`file://${file}`);
  await page.waitForSelector('html[data-ready]');
  const picture = await page.locator('#scene').screenshot();
  const paper = await page.evaluate(async (image) => {  // the colour in its corner
    const bytes = Uint8Array.from(atob(image), (c) => c.charCodeAt(0));
    const pen = new OffscreenCanvas(1, 1).getContext('2d');
    pen.drawImage(await createImageBitmap(new Blob([bytes], { type: 'image/png' }), 8, 8, 1, 1), 0, 0);
    return `rgb(${pen.getImageData(0, 0, 1, 1).data.slice(0, 3).join(', ')})`;
  }, picture.toString('base64'));
  await page.close();
  return { paper, html: `<div style="overflow: hidden"><img width="${width}" height="${height}"
    style="object-fit: cover; transform: scale(1.4)" src="data:image/png;base64,${picture.toString('base64')}"></div>` };
}

/** What draws a body by three.js, whose modules come from the folder. */
const drawing = (glb, width, height) => `
import * as THREE from 'http://three/build/three.module.js';
import { GLTFLoader } from 'http://three/examples/jsm/loaders/GLTFLoader.js';
const bytes = Uint8Array.from(atob('${glb.toString('base64')}'), (c) => c.charCodeAt(0));
const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, '');
scene.traverse((part) => {
  if (part.isMesh) part.material = new THREE.MeshStandardMaterial({ color: 0x3b76af, roughness: 0.55, flatShading: true });
});
const ball = new THREE.Box3().setFromObject(scene).getBoundingSphere(new THREE.Sphere());
const camera = new THREE.PerspectiveCamera(35, ${width} / ${height}, 0.01, 100 * ball.radius);
camera.up.set(0, 0, 1);
camera.position.copy(ball.center).add(new THREE.Vector3(0.5, -0.8, 1.6).setLength(3.1 * ball.radius));
camera.lookAt(ball.center);
const light = new THREE.DirectionalLight(0xffffff, 2.5);
light.position.set(1, -1, 2);
scene.add(new THREE.HemisphereLight(0xffffff, 0x555566, 1.6), light);
const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
renderer.setSize(${width}, ${height});
renderer.render(scene, camera);
document.querySelector('#body').append(renderer.domElement);
document.documentElement.dataset.ready = '';`;

/** The page of a curve, and beside it a body along it. */
async function pageAndBody(name, html, glb) {
  const [width, height] = [460, 400];
  const page = await browser.newPage({ viewport: { width: 2 * width, height } });
  await page.route('http://three/**', (route) => {
    const path = new URL(route.request().url()).pathname;
    route.fulfill({
      contentType: 'text/javascript',
      body: readFileSync(join(modules, 'three', path), 'utf8').replaceAll(/from 'three'/g, "from 'http://three/build/three.module.js'"),
      headers: { 'Access-Control-Allow-Origin': '*' },
    });
  });
  const { paper, html: left } = await scene(html, width, height);
  await page.setContent(`<body style="margin: 0; display: flex; background: ${paper}">${left}<div id="body"></div></body>`);
  await page.addScriptTag({ type: 'module', content: drawing(readFileSync(glb), width, height) });
  await page.waitForSelector('html[data-ready]');
  await page.screenshot({ path: join(figures, name) });
  await page.close();
}

const curve = join(folder, 'trefoil.json');
const html = join(folder, 'trefoil.html');
const glb = join(folder, 'trefoil.glb');
run('construct', join(examples, 'paths/trefoil.csv'), '--closed', '-o', curve);
run('page', curve, '-o', html);
run('sweep', curve, '--profile', 'rectangle:0.4,0.4', '-o', glb);
await pageAndBody('waypoints.png', html, glb);
await browser.close();
rmSync(folder, { recursive: true });
