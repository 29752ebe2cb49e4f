// node build.mjs OUTPUT.cpp: the page without its data, as a C++ source.
// One HTML file with its style, its program and KaTeX's fonts in it, so that it needs no network.
import { build } from 'esbuild';
import { readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
if (!output) throw new Error('usage: node build.mjs OUTPUT.cpp');

// KaTeX names each font in three formats; browsers that have WebGL 2 read woff2.
const onlyWoff2 = {
  name: 'only-woff2',
  setup(build) {
    build.onResolve({ filter: /\.(woff|ttf)$/ }, () => ({ path: 'none', namespace: 'none' }));
    build.onLoad({ filter: /.*/, namespace: 'none' }, () => ({ contents: '', loader: 'dataurl' }));
  },
};

const bundle = async (entry, format) =>
  (
    await build({
      entryPoints: [join(here, 'src', entry)],
      bundle: true,
      minify: true,
      write: false,
      target: ['chrome100', 'firefox100', 'safari15'],
      format,
      legalComments: 'eof',
      loader: { '.woff2': 'dataurl' },
      plugins: [onlyWoff2],
    })
  ).outputFiles[0].text;

// Inside an element's text "</script" and "</style" would end it.
const inside = (text, element) => text.replaceAll(`</${element}`, `<\\/${element}`);

const script = inside(await bundle('main.js', 'iife'), 'script');
const style = inside(await bundle('page.css', undefined), 'style');
const html = readFileSync(join(here, 'src', 'page.html'), 'utf8')
  .replace('/*style*/', () => style)
  .replace('/*script*/', () => script);

// A compiler need not take string literals of more than 65536 bytes.
const delimiter = 'phrame~page';
if (html.includes(`)${delimiter}"`)) throw new Error('the delimiter is in the page');
const pieces = [];
for (let rest = Buffer.from(html); rest.length > 0;) {
  let length = Math.min(rest.length, 16000);
  while (length < rest.length && (rest[length] & 0xc0) === 0x80) --length;
  pieces.push(rest.subarray(0, length).toString());
  rest = rest.subarray(length);
}
writeFileSync(
  output,
  `// Made from page/ by its build.mjs.
#include "phrame/io/write/page_template.hpp"

namespace phrame::inline v0 {

const std::vector<std::string_view>& page_template() {
  static const std::vector<std::string_view> pieces{
${pieces.map((piece) => `R"${delimiter}(${piece})${delimiter}"`).join(',\n')}};
  return pieces;
}

}  // namespace phrame
`,
);
