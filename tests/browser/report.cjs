// Opens HTML reports in headless Chromium as readers do: with and without scripts, in light, dark and narrow,
// by keyboard, on paper. Any message on the console is a failure.
"use strict";
const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const { chromium } = require("playwright-core");

const [work, shots, ...names] = process.argv.slice(2);
const axe = fs.readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync", "--disable-quic"];
const views = [
  { name: "light", colorScheme: "light", viewport: { width: 1100, height: 1400 } },
  { name: "dark", colorScheme: "dark", viewport: { width: 1100, height: 1400 } },
  { name: "narrow", colorScheme: "light", viewport: { width: 360, height: 1400 }, hasTouch: true, isMobile: true },
];

async function open(browser, name, options = {}) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const said = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("dialog", (dialog) => { said.push(`dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) said.push(`request: ${request.url()}`);
  });
  await page.goto(`file://${path.resolve(work, `${name}.html`)}`);
  const close = async () => {
    assert.deepStrictEqual(said, [], `${name}: the console`);
    await context.close();
  };
  return { page, close };
}

const visible = (page) => page.locator("article:visible").count();

async function looks(browser, name) {
  for (const view of views) {
    const { page, close } = await open(browser, name, view);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${name}, ${view.name}: ${wide} pixels too wide`);
    await page.screenshot({ path: path.join(shots, `${name}-${view.name}.png`) });
    await close();
    // The policy of the page keeps foreign scripts out, so the checker needs it lifted.
    const checked = await open(browser, name, { ...view, bypassCSP: true });
    await checked.page.evaluate(axe);
    const { violations } = await checked.page.evaluate(() => axe.run());
    const told = violations.map((one) => `${one.id}: ${one.help}: ${one.nodes[0].html.slice(0, 200)}`);
    assert.deepStrictEqual(told, [], `${name}, ${view.name}: accessibility`);
    await checked.close();
  }
}

async function withoutScripts(browser, name) {
  const { page, close } = await open(browser, name, { javaScriptEnabled: false });
  assert.ok(await page.locator("article").first().isVisible(), "findings are readable without scripts");
  assert.ok(!(await page.locator("#controls").isVisible()), "no dead controls without scripts");
  await close();
}

async function narrows(browser, name) {
  const { page, close } = await open(browser, name);
  const all = await visible(page);
  const rule = await page.locator("article").last().getAttribute("data-rule");
  await page.fill("#search", rule);
  const found = await visible(page);
  assert.ok(found > 0 && found < all, `search: ${found} of ${all}`);
  assert.match(await page.textContent("#shown"), new RegExp(`^${found} of ${all} findings$`));
  await page.fill("#search", "there is no such word");
  assert.strictEqual(await visible(page), 0);
  await page.click("#again");
  assert.strictEqual(await visible(page), all);
  await page.selectOption("#rule", rule);
  assert.strictEqual(await visible(page), await page.locator(`article[data-rule="${rule}"]`).count());
  await page.click("#clear");
  await page.waitForFunction((all) => document.querySelectorAll("article:not([hidden])").length === all, all);
  const level = await page.locator("[name=level]").first().getAttribute("value");
  await page.uncheck(`[name=level][value=${level}]`);
  assert.strictEqual(await page.locator(`article[data-level=${level}]:visible`).count(), 0);
  await page.click("#clear");
  for (const order of ["level", "rule", "path"]) {
    await page.selectOption("#order", order);
    assert.strictEqual(await visible(page), all, `order by ${order} keeps all`);
    const keys = await page.locator("article").evaluateAll((nodes, key) => nodes.map((node) => node.dataset[key]), order);
    const changes = keys.filter((key, at) => at === 0 || key !== keys[at - 1]).length;
    assert.strictEqual(changes, new Set(keys).size, `order by ${order} groups`);
  }
  await close();
}

async function byKeyboard(browser, name) {
  const { page, close } = await open(browser, name);
  const focused = () => page.evaluate(() => document.activeElement.closest("article")?.id ?? document.activeElement.id);
  const ids = await page.locator("article").evaluateAll((nodes) => nodes.map((node) => node.id));
  await page.keyboard.press("/");
  assert.strictEqual(await focused(), "search");
  await page.keyboard.type("jk/");
  assert.strictEqual(await page.inputValue("#search"), "jk/", "keys are text in the search");
  await page.keyboard.press("Escape");
  assert.strictEqual(await page.inputValue("#search"), "");
  await page.keyboard.press("j");
  assert.strictEqual(await focused(), ids[0]);
  await page.keyboard.press("j");
  assert.strictEqual(await focused(), ids[Math.min(1, ids.length - 1)]);
  await page.keyboard.press("k");
  assert.strictEqual(await focused(), ids[0]);
  const isOpen = () => page.evaluate(() => document.activeElement.parentElement.open);
  const before = await isOpen();
  await page.keyboard.press("Enter");
  assert.notStrictEqual(await isOpen(), before, "Enter opens and closes");
  await page.click("#fold");
  await page.evaluate((id) => { location.hash = id; }, ids.at(-1));
  await page.waitForFunction((id) => document.getElementById(id).querySelector("details").open, ids.at(-1));
  await close();
}

async function onPaper(browser, name) {
  const { page, close } = await open(browser, name);
  await page.click("#fold");
  await page.pdf({ path: path.join(shots, `${name}.pdf`) });
  await page.emulateMedia({ media: "print" });
  assert.ok(await page.locator("article dl").first().isVisible(), "closed findings are printed");
  assert.ok(!(await page.locator("#controls").isVisible()), "controls are not printed");
  await close();
}

(async () => {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  const browser = await chromium.launch({ executablePath, args: flags });
  let passed = 0;
  for (const name of names) {
    // A page without findings has nothing to search.
    const tests = name === "clean" ? [looks] : [looks, withoutScripts, narrows, byKeyboard, onPaper];
    for (const test of tests) {
      await test(browser, name);
      passed += 1;
      console.log(`ok ${name}: ${test.name}`);
    }
  }
  await browser.close();
  console.log(`${passed} passed, 0 failed`);
})().catch((error) => {
  console.error(error);
  process.exitCode = 1;
  process.exit();
});
