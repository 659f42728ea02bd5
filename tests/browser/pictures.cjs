// Takes pictures of HTML reports as the guides show them: the artist's in light with its first finding, the maintainer's in
// dark from the filters on, with findings in the order of their rules and closed.
"use strict";
const path = require("node:path");
const { chromium } = require("playwright-core");

const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking",
  "--font-render-hinting=none", "--force-color-profile=srgb"];
const WIDTH = 940;
const MARGIN = 20;
const views = {
  "artist-page": { colorScheme: "light", from: "header", last: 0, prepare: async () => {} },
  "maintainer-page": {
    colorScheme: "dark",
    from: "#controls",
    last: 5,
    prepare: async (page) => {
      await page.selectOption("#order", "rule");
      await page.click("#fold");
      await page.getByText("Files with findings").click();
      await page.evaluate(() => document.activeElement.blur());
    },
  },
};

(async () => {
  const [folder, ...pages] = process.argv.slice(2);
  const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
  const browser = await chromium.launch({ executablePath, args: flags });
  for (const file of pages) {
    const name = path.basename(file, ".html");
    const { colorScheme, from, last, prepare } = views[name];
    const page = await browser.newPage({ colorScheme, viewport: { width: WIDTH, height: 1000 } });
    await page.goto(`file://${path.resolve(file)}`);
    await prepare(page);
    const top = (await page.locator(from).first().boundingBox()).y - MARGIN;
    const { y, height } = await page.locator("article").nth(last).boundingBox();
    const clip = { x: 0, y: top, width: WIDTH, height: Math.ceil(y + height) + MARGIN - top };
    await page.screenshot({ path: path.join(folder, `${name}.png`), fullPage: true, clip });
  }
  await browser.close();
})().catch((error) => {
  console.error(error);
  process.exitCode = 1;
});
