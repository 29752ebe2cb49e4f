// node page_test.mjs PROGRAM CURVES PICTURES: pages as their readers meet them, in a headless Chromium. Values
// are compared with what other commands of the program print, bytes with what these write.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const [program, curves, pictures] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'phrame-page-'));
mkdirSync(pictures, { recursive: true });
const run = (...words) => execFileSync(program, words, { encoding: 'utf8', maxBuffer: 1 << 27 });

const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
  // Root, as in a fresh machine's first shell, has no sandbox.
  chromiumSandbox: process.getuid() !== 0,
  args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});

/** The page of a curve, opened from its file; it must neither complain nor ask for anything. */
async function open(curve, options = [], view = {}) {
  return openBy(['page', curve, ...options], view);
}

/** The page that a command writes. */
async function openBy(words, view = {}) {
  const file = join(folder, 'page.html');
  run(...words, '-o', file);
  const context = await browser.newContext({
    viewport: { width: 1280, height: 900 },
    acceptDownloads: true,
    ...view,
  });
  const page = await context.newPage();
  page.setDefaultTimeout(120_000);  // of a machine that is busy with other things, too
  const complaints = [];
  page.on('console', (message) => {
    // A software renderer says that reading back pictures is slow.
    if (message.type() === 'error' || (message.type() === 'warning' && !/GPU stall/.test(message.text())))
      complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(error.message));
  page.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(`file://${file}`);
  await page.waitForSelector('html[data-ready]');
  return { page, complaints, close: () => context.close() };
}

const at = (page) => page.textContent('#at');
/** The numbers of a row of the table of the place. */
const shown = (page, name) =>
  page.$$eval(
    '#numbers tr',
    (lines, name) =>
      lines
        .filter((line) => line.firstChild.textContent === name)
        .flatMap((line) => [...line.querySelectorAll('td')].map((cell) => cell.textContent))
        .filter((text) => text !== '')
        .map((text) => text.replace('−', '-')),
    name,
  );
/** The scene as an image, and how many colours it has. */
const picture = (page) => page.locator('#scene').screenshot();
async function colours(page) {
  const image = (await picture(page)).toString('base64');
  return page.evaluate(async (image) => {
    const bytes = Uint8Array.from(atob(image), (c) => c.charCodeAt(0));
    const map = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const canvas = new OffscreenCanvas(map.width, map.height);
    const pen = canvas.getContext('2d');
    pen.drawImage(map, 0, 0);
    const words = new Uint32Array(pen.getImageData(0, 0, map.width, map.height).data.buffer);
    return new Set(words).size;
  }, image);
}

/** The number of the row at t. */
const rowAt = (page, t) =>
  page.evaluate((t) => {
    const lines = JSON.parse(document.getElementById('data').textContent).csv.trim().split('\n').slice(1);
    return lines.findIndex((line) => Number(line.split(',')[0]) === t);
  }, t);

/** How many colours the edge of the scene has. */
async function edges(page) {
  await page.evaluate(() => scrollTo(0, 0));
  const image = (await picture(page)).toString('base64');
  return page.evaluate(async (image) => {
    const bytes = Uint8Array.from(atob(image), (c) => c.charCodeAt(0));
    const map = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const pen = new OffscreenCanvas(map.width, map.height).getContext('2d', { willReadFrequently: true });
    pen.drawImage(map, 0, 0);
    const { width, height } = map;
    const inset = 14; // where corners are round
    const lines = [[inset, 2, width - 2 * inset, 1], [inset, height - 3, width - 2 * inset, 1], [2, inset, 1, height - 2 * inset], [width - 3, inset, 1, height - 2 * inset]];
    const colours = new Set();
    for (const line of lines) for (const word of new Uint32Array(pen.getImageData(...line).data.buffer)) colours.add(word);
    return colours.size;
  }, image);
}

const quintic = join(curves, 'curves', 'farouki-2003-quintic.json');

const tests = {
  async 'opens without a complaint and shows a picture'() {
    const { page, complaints, close } = await open(quintic);
    assert.equal(await page.title(), 'farouki-2003-quintic');
    assert.ok((await colours(page)) > 20);
    assert.ok((await page.locator('.katex').count()) > 0);
    assert.equal(await page.locator('.katex-error').count(), 0);
    await page.screenshot({ path: join(pictures, 'quintic.png'), fullPage: true });
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'the slider moves the frame to the numbers of phrame frames'() {
    const { page, close } = await open(quintic);
    for (const t of ['1/8', '77/240', '1']) {
      const [names, numbers] = run('frames', quintic, '--at', t, '--columns', 's,curvature,torsion')
        .split('\n')
        .map((line) => line.split(','));
      const wanted = Object.fromEntries(names.map((name, k) => [name, Number(numbers[k])]));
      await page.locator('#slider').fill(String(await rowAt(page, wanted.t)));
      assert.equal(Number((await at(page)).slice(4)), wanted.t);
      const expect = async (row, ...keys) =>
        assert.deepEqual((await shown(page, row)).map(Number), keys.map((key) => wanted[key]));
      await expect('r', 'x', 'y', 'z');
      await expect('f₂', 'f2x', 'f2y', 'f2z');
      await expect('f₃', 'f3x', 'f3y', 'f3z');
      await expect('κ', 'curvature');
      await expect('τ', 'torsion');
      await expect('s', 's');
      const angle = JSON.parse(run('angle', quintic, '--start', 'least', '--at', t, '--digits', '17', '--print', 'json'));
      const [theta] = await shown(page, 'θ');
      assert.ok(Math.abs(theta - angle.values[0].theta) <= Math.abs(theta) * 2 ** -52);
    }
    await close();
  },

  async 'ribbons are switched, by mouse and by keys, and keys walk along the curve'() {
    const { page, complaints, close } = await open(quintic);
    const first = await picture(page);
    await page.getByText('Frenet', { exact: true }).click();
    const second = await picture(page);
    assert.ok(!first.equals(second));
    await page.locator('#scene').focus();
    await page.keyboard.press('3');
    await page.keyboard.press('2');
    assert.ok(!(await picture(page)).equals(second));
    assert.equal(await page.locator('#ribbons input:checked').count(), 2);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowLeft');
    assert.equal(Number((await at(page)).slice(4)), 10 / 240);
    await page.keyboard.press(' ');
    await page.waitForFunction(() => document.querySelector('#slider').valueAsNumber > 14);
    await page.keyboard.press(' ');
    const label = await page.getAttribute('#scene', 'aria-label');
    assert.match(label, /^PH quintic, degree 5.*Frames shown: rotation-minimizing; Euler–Rodrigues\.$/);
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'what is taken along has the bytes that the program writes'() {
    const { page, close } = await open(quintic);
    const bytes = async (name) => {
      const download = page.waitForEvent('download');
      await page.getByRole('button', { name, exact: true }).click();
      return readFileSync(await (await download).path(), 'utf8');
    };
    const stem = 'farouki_2003_quintic';
    assert.equal(await bytes(`${stem}-angle.json`), run('angle', quintic, '--start', 'least', '--print', 'json'));
    assert.equal(await bytes(`${stem}.cert`), run('certify', quintic));
    assert.equal(await bytes(`${stem}.h`), run('compile', quintic));
    const table = run('frames', quintic, '--samples', '241', '--frame', 'rmf,erf,frenet', '--columns', 's,curvature,torsion');
    const width = table.split('\n', 1)[0].split(',').length;
    // There are more rows where the graphs turn.
    const mine = new Set((await bytes(`${stem}-frames.csv`)).split('\n').map((line) => line.split(',').slice(0, width).join(',')));
    for (const line of table.split('\n')) assert.ok(mine.has(line), line);
    await close();
  },

  async 'a name is a text, whatever it says'() {
    const hostile = join(folder, 'hostile.json');
    const name = '</script><script>document.title="x"</script><!-- & <img src=x onerror=alert(1)>';
    const curve = JSON.parse(readFileSync(quintic, 'utf8'));
    writeFileSync(hostile, JSON.stringify({ ...curve, name }));
    const { page, complaints, close } = await open(hostile);
    assert.equal(await page.title(), name);
    assert.equal(await page.textContent('#name'), name);
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'closed splines come back turned by the holonomy, and a frame of minimal twist closes'() {
    const { page, complaints, close } = await open(join(curves, 'curves', 'closed-spline.json'));
    const said = await page.textContent('#formula');
    const { holonomy } = JSON.parse(run('angle', join(curves, 'curves', 'closed-spline.json'), '--print', 'json'));
    assert.ok(said.includes(holonomy.value), said);
    await page.getByText('minimal twist, closed', { exact: true }).click();
    const first = await shown(page, 'm₂');
    await page.keyboard.press('Escape');
    await page.locator('#slider').fill(await page.getAttribute('#slider', 'max'));
    assert.deepEqual(await shown(page, 'm₂'), first);
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'curves of any kind, lines among them'() {
    for (const name of ['any/trefoil.json', 'any/nurbs-circle.json', 'any/wave.svg', 'curves/plane-cubic.json']) {
      const { page, complaints, close } = await open(join(curves, name));
      assert.ok((await colours(page)) > 20, name);
      assert.deepEqual(complaints, [], name);
      await close();
    }
  },

  async 'frames of others stand beside the exact ones, with their error'() {
    const table = join(folder, 'mine.csv');
    const frenet = run('frames', quintic, '--frame', 'frenet', '--samples', '21');
    writeFileSync(table, frenet.replace(/\bn([xyz])\b/g, 'f2$1').replace(/\bb([xyz])\b/g, 'f3$1'));
    const { page, complaints, close } = await open(quintic, ['--frames', table]);
    assert.ok(await page.getByText('given', { exact: true }).isVisible());
    await page.locator('#slider').fill(String(await rowAt(page, 0.5)));
    let verdict;
    try {
      verdict = run('check', quintic, table, '--print', 'json');
    } catch (error) {
      verdict = error.stdout; // they are no rotation-minimizing frames: status 1
    }
    const [error] = await shown(page, 'error');
    const proved = JSON.parse(verdict).samples[10].error;
    assert.ok(Math.abs(error - proved.value) <= 2 * proved.radius);
    assert.match(await page.textContent('#facts'), /Frenet frame/);
    await page.screenshot({ path: join(pictures, 'given.png'), fullPage: true });
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'the rows hold the greatest curvature, and ticks their numbers'() {
    // κ of r′ = A i A*, A = (t − 1/2)² + 10⁻² j …, next to a cusp; its greatest value by golden section, in doubles.
    const curve = join(folder, 'near-cusp.json');
    const eps = 1e-3;
    writeFileSync(curve, JSON.stringify({ phrame: 'curve/1', basis: 'power', preimage: { u: [-0.5, 1], v: [0], p: [eps, 0], q: [0, eps] } }));
    const curvature = (t) => {
      // A = u + p j + q k: r′ = (u² − p² − q², 2uq, −2up).
      const [u, p, q] = [t - 0.5, eps, eps * t];
      const first = [u * u - p * p - q * q, 2 * u * q, -2 * u * p];
      const second = [2 * u - 2 * q * eps, 2 * q + 2 * u * eps, -2 * p];
      const cross = [0, 1, 2].map((k) => first[(k + 1) % 3] * second[(k + 2) % 3] - first[(k + 2) % 3] * second[(k + 1) % 3]);
      return Math.hypot(...cross) / Math.hypot(...first) ** 3;
    };
    let greatest = 0;
    for (let k = -20000; k <= 20000; ++k) greatest = Math.max(greatest, curvature(0.5 + k * 1e-6));
    const { page, complaints, close } = await open(curve);
    const found = await page.evaluate(() => {
      const lines = JSON.parse(document.getElementById('data').textContent).csv.trim().split('\n').map((line) => line.split(','));
      const column = lines[0].indexOf('curvature');
      return Math.max(...lines.slice(1).map((line) => Number(line[column])));
    });
    assert.ok(Math.abs(found / greatest - 1) < 1e-4, `${found}, ${greatest}`);
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll('#plots svg')].map((image) => {
        const frame = image.getBoundingClientRect();
        const ticks = [...image.querySelectorAll('.tick text')].map((text) => text.getBoundingClientRect());
        return { count: ticks.length, cut: ticks.some((text) => text.left < frame.left - 1) };
      }),
    );
    assert.ok(cut.length >= 4 && cut.every(({ count, cut }) => count >= 3 && !cut), JSON.stringify(cut));
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'at four widths, light and dark, nothing is covered by anything after scrolling'() {
    const { page, complaints, close } = await open(quintic);
    for (const width of [360, 768, 1280, 1920])
      for (const colorScheme of ['light', 'dark']) {
        await page.setViewportSize({ width, height: 800 });
        await page.emulateMedia({ colorScheme });
        const covered = await page.evaluate(async () => {
          const found = [];
          if (document.documentElement.scrollWidth > innerWidth) found.push(`wider than ${innerWidth}`);
          for (const id of ['formula', 'poles', 'facts', 'downloads', 'plots']) {
            const part = document.getElementById(id);
            for (const block of ['start', 'center', 'end']) {
              part.scrollIntoView({ block });
              await new Promise((done) => requestAnimationFrame(done));
              const box = part.getBoundingClientRect();
              const middle = (Math.max(box.top, 0) + Math.min(box.bottom, innerHeight)) / 2;
              for (const share of [0.05, 0.5, 0.95]) {
                const at = document.elementFromPoint(box.left + share * box.width, middle);
                if (at && !part.contains(at) && !at.contains(part)) found.push(`${id} by ${at.id || at.tagName}`);
              }
            }
          }
          return found;
        });
        assert.deepEqual(covered, [], `${width}, ${colorScheme}`);
        await page.screenshot({ path: join(pictures, `quintic-${width}-${colorScheme}.png`) });
      }
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'an error of 0.056 radians is said and magnified'() {
    const table = join(folder, 'drifting.csv');
    const [names, ...lines] = run('frames', quintic, '--frame', 'rmf', '--samples', '21').trim().split('\n').map((line) => line.split(','));
    const drifted = lines.map((line) => {
      const at = (name) => Number(line[names.indexOf(name)]);
      const angle = 0.056 * at('t') ** 2;
      const turned = (a, b) => ['x', 'y', 'z'].map((axis) => Math.cos(angle) * at(a + axis) + b[1] * Math.sin(angle) * at(b[0] + axis));
      return [at('t'), ...turned('f2', ['f3', 1]), ...turned('f3', ['f2', -1])].join(',');
    });
    writeFileSync(table, ['t,f2x,f2y,f2z,f3x,f3y,f3z', ...drifted].join('\n'));
    const { page, complaints, close } = await open(quintic, ['--frames', table]);
    assert.match(await page.textContent('#error'), /off by up to 0\.056 rad, at t = 1\..* 10 times/);
    const magnified = await picture(page);
    await page.getByText('error × 10', { exact: true }).click();
    assert.ok(!(await picture(page)).equals(magnified));
    assert.deepEqual(complaints, []);
    await close();
  },

  async 'at joints where a number jumps its line has a gap'() {
    const { page, close } = await open(join(curves, 'curves', 'closed-spline.json'));
    const strokes = await page.$$eval('#plots figure', (figures) =>
      Object.fromEntries(
        figures.map((figure) => [
          figure.querySelector('b').textContent,
          figure.querySelector('path[clip-path]').getAttribute('d').split('M').length - 1,
        ]),
      ),
    );
    // Four segments: κ and |r′| are other numbers on both sides of the three joints, θ and s go on.
    assert.deepEqual([strokes.κ, strokes['|r′|'], strokes.θ, strokes.s], [4, 4, 1, 1]);
    await close();
  },

  async 'what is said reads well'() {
    const spline = join(folder, 'trefoil.json');
    run('construct', join(curves, 'paths', 'trefoil.csv'), '--closed', '-o', spline);
    for (const curve of [spline, join(curves, 'curves/plane-cubic.json'), join(curves, 'any/helix.json'), quintic]) {
      const { page, close } = await open(curve);
      const text = await page.evaluate(() =>
        ['formula', 'poles', 'facts', 'along'].map((id) => document.getElementById(id).innerText).join('\n'),
      );
      assert.doesNotMatch(text, /[a-z]\.[A-Z]/, curve);
      assert.doesNotMatch(text, /0 *\+ *C/, curve);
      assert.doesNotMatch(text, /(^|[\s(=,≈±])-[\d.]/m, curve);
      if (/helix/.test(curve)) assert.match(text, /t goes from 0 to 1 while s /);
      await close();
    }
  },

  async 'frames are told apart without colour, by eyes without a kind of cones, and from the paper'() {
    // [Machado, Oliveira, Fernandes 2009], for linear RGB.
    const eyes = {
      all: [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
      deuteranopes: [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
      protanopes: [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    };
    const linear = (rgb) => rgb.map((x) => (x / 255 <= 0.04045 ? x / 255 / 12.92 : ((x / 255 + 0.055) / 1.055) ** 2.4));
    const light = ([r, g, b]) => 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const lab = ([r, g, b]) => {
      const f = (t) => (t > 0.008856 ? Math.cbrt(t) : 7.787 * t + 16 / 116);
      const [x, y, z] = [(0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047, light([r, g, b]), (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883];
      return [116 * f(y) - 16, 500 * (f(x) - f(y)), 200 * (f(y) - f(z))];
    };
    const seen = (rgb, eye) => lab(eye.map((row) => Math.max(0, row.reduce((sum, x, k) => sum + x * linear(rgb)[k], 0))));
    const table = join(folder, 'rmf.csv');
    writeFileSync(table, run('frames', quintic, '--frame', 'rmf', '--samples', '9'));
    const { page, close } = await open(quintic, ['--frames', table, '--end-normal', '0,0,1']);
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme });
      const { colours, dashes, paper } = await page.evaluate(() => {
        const rgb = (colour) => colour.match(/[\d.]+/g).slice(0, 3).map(Number);
        const swatches = [...document.querySelectorAll('.swatch')];
        return {
          colours: swatches.map((swatch) => rgb(getComputedStyle(swatch).color)),
          dashes: swatches.map((swatch) => swatch.querySelector('line').getAttribute('stroke-dasharray')),
          paper: rgb(getComputedStyle(document.getElementById('view')).backgroundColor),
        };
      });
      assert.equal(colours.length, 5);
      assert.equal(new Set(dashes).size, 5);
      for (const colour of colours) {
        const [high, low] = [light(linear(colour)), light(linear(paper))].sort((a, b) => b - a);
        assert.ok((high + 0.05) / (low + 0.05) >= 3, `${colour} on ${paper}`);
        for (const other of colours)
          for (const [who, eye] of Object.entries(eyes)) {
            if (other === colour) continue;
            const [a, b] = [seen(colour, eye), seen(other, eye)];
            assert.ok(Math.hypot(...a.map((x, k) => x - b[k])) >= 20, `${who}: ${colour}, ${other}`);
          }
      }
    }
    await close();
  },

  async 'on paper parts follow one another, light, and nothing is wider than the sheet'() {
    const { page, close } = await open(quintic, ['--end-normal', '0,0,1'], { colorScheme: 'dark', viewport: { width: 690, height: 1000 } });
    await page.emulateMedia({ media: 'print' });
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const { tops, width, papers, isSeen } = await page.evaluate(async () => {
      await document.querySelector('#scene img').decode();
      const parts = ['view', 'here', 'along', 'formula', 'poles', 'facts'].map((id) => document.getElementById(id).getBoundingClientRect());
      return {
        tops: parts.flatMap(({ top, bottom }) => [top, bottom]),
        width: document.documentElement.scrollWidth,
        papers: getComputedStyle(document.body).backgroundColor,
        isSeen: [...document.querySelectorAll('#facts details')].every((part) => part.open),
      };
    });
    for (let k = 1; k < tops.length; ++k) assert.ok(tops[k] >= tops[k - 1] - 1, `${tops}`);
    assert.equal(width, 690);
    assert.equal(papers, 'rgb(255, 255, 255)');
    assert.ok(isSeen);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    assert.equal(await page.locator('#scene img').count(), 0);
    assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
    await page.pdf({ path: join(pictures, 'quintic.pdf'), format: 'A4', printBackground: true });
    await close();
  },

  async 'offsets: marks, points next to the pointer, what is cut away, and a view that moves'() {
    const words = ['offset', join(curves, 'curves', 'plane-cubic.json'), '--distance', '-1,1/2'];
    const { page, complaints, close } = await openBy(words);
    const told = () => page.textContent('#at');
    const hint = await told();
    const cusp = page.locator('#drawing .mark');
    assert.equal(await cusp.count(), 1);
    await cusp.hover();
    assert.match(await told(), /^d = −1, cusp: t = 0\.643594252905…, /);
    // The point at t = 1/2 with d = 1/2, (1/2 − 1/24 + 2/5, 1/4 − 3/10), where the page draws it.
    const [t, x, y, px, py] = await page.evaluate(() => layers[1].samples[100]);
    assert.equal(t, '1/2');
    assert.deepEqual([x, y], ['0.858333333333', '−0.0500000000000']);
    const spot = await page.evaluate(([px, py]) => {
      const at = new DOMPoint(px, py).matrixTransform(svg.getScreenCTM());
      return [at.x, at.y];
    }, [px, py]);
    await page.mouse.move(...spot);
    assert.equal(await told(), `d = 1/2, t = 1/2: (${x}, ${y})`);
    await page.screenshot({ path: join(pictures, 'offsets.png'), fullPage: true });
    const view = () => page.getAttribute('#drawing', 'viewBox');
    const before = await view();
    await page.mouse.wheel(0, -200);
    await page.waitForFunction((before) => svg.getAttribute('viewBox') !== before, before);
    await page.mouse.down();
    await page.mouse.move(spot[0] + 40, spot[1]);
    await page.mouse.up();
    await page.locator('#all').click();
    assert.equal(await view(), before);
    await page.locator('#show-0').uncheck();
    assert.equal(await cusp.isVisible(), false);
    await page.locator('#marks tbody tr').click();
    assert.match(await told(), /cusp/);
    await page.locator('#drawing').press('Escape');
    assert.equal(await told(), hint);
    assert.deepEqual(complaints, []);
    await close();
    const trimmed = await openBy([...words, '--trim'], { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
    assert.equal(await trimmed.page.evaluate(() => document.documentElement.scrollWidth), 390);
    await trimmed.page.locator('#show-whole').uncheck();
    assert.equal(await trimmed.page.locator('.whole').first().isVisible(), false);
    await trimmed.page.screenshot({ path: join(pictures, 'offsets-trimmed.png'), fullPage: true });
    assert.deepEqual(trimmed.complaints, []);
    await trimmed.close();
  },

  async 'on a telephone, in the dark, nothing is wider than the screen'() {
    const long = join(folder, 'long.json');
    writeFileSync(long, JSON.stringify({ ...JSON.parse(readFileSync(quintic, 'utf8')), name: 'a-name-without-a-blank-'.repeat(9) }));
    const { page, complaints, close } = await open(long, [], {
      viewport: { width: 390, height: 844 },
      colorScheme: 'dark',
      isMobile: true,
      hasTouch: true,
    });
    const { width, ground } = await page.evaluate(() => ({
      width: document.documentElement.scrollWidth,
      ground: getComputedStyle(document.body).backgroundColor,
    }));
    assert.equal(width, 390);
    const cut = await page.$$eval('.equation', (boxes) => boxes.filter((box) => box.scrollWidth > box.clientWidth).length);
    assert.equal(cut, 0);
    assert.equal(ground, 'rgb(22, 24, 29)');
    assert.deepEqual(await edges(page), 1, 'the curve is cut at the edge of its picture');
    await page.screenshot({ path: join(pictures, 'telephone.png'), fullPage: true });
    // A finger that goes along a plot takes the slider with it; the browser does not take it for scrolling.
    const plot = page.locator('#plots svg').first();
    await plot.scrollIntoViewIfNeeded();
    const { x, y, width: length } = await plot.boundingBox();
    const touch = await page.context().newCDPSession(page);
    const send = (type, share) =>
      touch.send('Input.dispatchTouchEvent', { type, touchPoints: share === null ? [] : [{ x: x + share * length, y: y + 50 + 6 * share }] });
    await send('touchStart', 0.3);
    for (let k = 4; k <= 9; ++k) await send('touchMove', k / 10);
    await send('touchEnd', null);
    const there = Number((await at(page)).slice(4));
    assert.ok(there > 0.8, `t = ${there}`);
    assert.deepEqual(complaints, []);
    await close();
  },
};

let failures = 0;
for (const [name, test] of Object.entries(tests)) {
  try {
    await test();
    console.log(`ok      ${name}`);
  } catch (error) {
    ++failures;
    console.log(`FAILED  ${name}\n${error.stack}`);
  }
}
await browser.close();
rmSync(folder, { recursive: true });
console.log(`pages: ${Object.keys(tests).length - failures} of ${Object.keys(tests).length} tests passed`);
process.exitCode = failures === 0 ? 0 : 1;
