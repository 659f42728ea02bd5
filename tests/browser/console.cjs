// Opens HTML reports in headless Chromium: any message on the console, any request, is a failure.
"use strict";
const assert = require("node:assert");
const path = require("node:path");
const { chromium } = require("playwright-core");

(async () => {
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking"];
  const browser = await chromium.launch({ executablePath, args: flags });
  const page = await browser.newPage();
  const said = [];
  page.on("console", (message) => said.push(message.text()));
  page.on("pageerror", (error) => said.push(String(error)));
  page.on("request", (request) => {
    if (!/^(file|data):/.test(request.url())) said.push(`request: ${request.url()}`);
  });
  const pages = process.argv.slice(2);
  for (const file of pages) {
    await page.goto(`file://${path.resolve(file)}`);
    const all = await page.locator("article").count();
    const shown = await page.locator("article:visible").count();
    assert.ok(all > 0 && shown === all, `${file}: ${shown} of ${all} findings are shown`);
    await page.fill("#search", "there is no such word");
    assert.strictEqual(await page.locator("article:visible").count(), 0, `${file}: the script runs`);
    assert.deepStrictEqual(said, [], `${file}: the console`);
  }
  await browser.close();
  console.log(`${pages.length} reports of damaged copies opened, nothing on the console`);
})().catch((error) => {
  console.error(error);
  process.exitCode = 1;
  process.exit();
});
