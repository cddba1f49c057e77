// The page in Chromium: node page.mjs <program that prints a page> <folder for it>
//
// Needs playwright-core (found from here, from NODE_PATH or from $TRIBUNAL_BROWSER_MODULES) and chromium. Without them it
// says what it left out and checks nothing.
import { execFileSync } from 'node:child_process';
import { existsSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

const [, , program, folder] = process.argv;
const file = join(folder, 'sample.html');
const html = execFileSync(program, { maxBuffer: 1 << 28 });
writeFileSync(file, html);
const interactive = html.includes('vegaEmbed=');

const checks = [];
const check = (name, run) => checks.push({ name, run });
const expect = (holds, what) => { if (!holds) throw new Error(what); };

check('no script is needed: without it every chart is drawn and every table is full', async (open) => {
  const page = await open({ javaScriptEnabled: false });
  expect(await page.locator('.chart .static svg').count() >= 4, 'static charts are missing');
  expect(await page.locator('.strip .tile').count() === 3, 'tiles are missing');
  expect(await page.locator('.matrix tbody tr').count() === 2, 'the matrix is incomplete');
});

check('interactive charts replace the static ones', async (open) => {
  const page = await open({});
  await page.evaluate(() => document.querySelectorAll('details').forEach((details) => { details.open = true; }));
  const charts = page.locator('.chart');
  for (let i = 0; i < await charts.count(); ++i) {
    await charts.nth(i).scrollIntoViewIfNeeded();
    if (!interactive) continue;
    await charts.nth(i).locator('.interactive svg').waitFor({ timeout: 20000 });
    expect(!await charts.nth(i).locator('.static').isVisible(), 'a static chart is still there');
  }
});

check('a click in a legend brings out one series', async (open) => {
  if (!interactive) return;
  const page = await open({});
  const chart = page.locator('#scaling ~ .pair .chart').first();
  await chart.scrollIntoViewIfNeeded();
  const button = chart.locator('.legend button').first();
  await button.click();
  expect(await button.getAttribute('aria-pressed') === 'true', 'the entry is not pressed');
  await page.waitForFunction(() => document.querySelector('#scaling ~ .pair .interactive [opacity="0.12"]') !== null);
});

check('tables sort by a click and by the keyboard', async (open) => {
  const page = await open({});
  const button = page.locator('.sortable th button').nth(3);
  await button.focus();
  await page.keyboard.press('Enter');
  const outcomes = await page.locator('.sortable tbody tr td:nth-child(4)').allTextContents();
  expect(outcomes.join() === [...outcomes].sort().join(), `not sorted: ${outcomes}`);
  expect(await page.locator('.sortable th').nth(3).getAttribute('aria-sort') === 'ascending', 'aria-sort is not set');
});

check('a link to a claim opens its evidence', async (open) => {
  const page = await open({});
  await page.locator('.tile a').first().click();
  expect(await page.locator('#claim-bound details').getAttribute('open') !== null, 'the evidence is closed');
});

check('a narrow window does not scroll sideways', async (open) => {
  const page = await open({ viewport: { width: 360, height: 700 } });
  expect(await page.evaluate(() => document.documentElement.scrollWidth) <= 360, 'the page is too wide');
});

check('both colour schemes have enough contrast', async (open) => {
  for (const colorScheme of ['light', 'dark']) {
    const page = await open({ colorScheme });
    const worst = await page.evaluate(() => {
      const channels = (text) => text.match(/[\d.]+/g).map(Number);
      const luminance = (c) => c.slice(0, 3).map((v) => v / 255)
        .map((v) => (v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4))
        .reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
      const background = (element) => {
        for (let e = element; e; e = e.parentElement) {
          const c = channels(getComputedStyle(e).backgroundColor);
          if (c.length === 3 || c[3] === 1) return c;
        }
        return [255, 255, 255];
      };
      return Math.min(...[...document.querySelectorAll('p, td, th, li, a, cite, .badge, .note, summary')]
        .filter((e) => e.textContent.trim() && e.getClientRects().length > 0)
        .map((e) => [luminance(channels(getComputedStyle(e).color)), luminance(background(e))].sort((a, b) => b - a))
        .map(([light, dark]) => (light + 0.05) / (dark + 0.05)));
    });
    expect(worst >= 4.5, `contrast ${worst.toFixed(2)} in ${colorScheme}`);
  }
});

const load = () => {
  for (const base of [import.meta.url, process.env.TRIBUNAL_BROWSER_MODULES && pathToFileURL(join(process.env.TRIBUNAL_BROWSER_MODULES, 'x'))].filter(Boolean)) {
    try { return createRequire(base)('playwright-core'); } catch { /* the next place */ }
  }
  return undefined;
};
const playwright = load();
const executablePath = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(existsSync);
if (!playwright || !executablePath) {
  console.log(`browser: 0 checks made, ${checks.length} left out: ${playwright ? 'chromium' : 'playwright-core'} is not installed`);
  process.exit(0);
}

const browser = await playwright.chromium.launch({ executablePath, args: ['--no-sandbox'] });
let failed = 0;
for (const { name, run } of checks) {
  const complaints = [];
  const open = async (options) => {
    const page = await (await browser.newContext(options)).newPage();
    page.on('console', (message) => { if (['error', 'warning'].includes(message.type())) complaints.push(message.text()); });
    page.on('pageerror', (error) => complaints.push(String(error)));
    page.on('request', (request) => { if (!/^(file|data):/.test(request.url())) complaints.push(`request to ${request.url()}`); });
    await page.goto(pathToFileURL(file).href);
    return page;
  };
  try {
    await run(open);
    expect(complaints.length === 0, complaints.join('; '));
    console.log(`ok      ${name}`);
  } catch (error) {
    failed += 1;
    console.log(`FAILED  ${name}: ${error.message}`);
  }
}
await browser.close();
console.log(`browser: ${checks.length} checks made, ${failed} failed, charts ${interactive ? 'interactive' : 'static (npm had not fetched the libraries)'}`);
process.exit(failed === 0 ? 0 : 1);
