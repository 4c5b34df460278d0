// What a reader can do with the report of a study: see, point, hide, choose; and what the page must not do.
//
//   node report_page.cjs CHROMIUM FOLDER_WITH_NODE_MODULES PAGE
"use strict";

const [chromium, modules, page_file] = process.argv.slice(2);
const playwright = require(require.resolve("playwright-core", { paths: [modules] }));

let failures = 0;
function check(what, passed, told = "") {
    console.log(`${passed ? "ok     " : "FAILED "} ${what}${passed ? "" : `: ${told}`}`);
    failures += !passed;
}

async function look(page, troubles) {
    const points = page.locator("#chart svg .mark-symbol path");
    await points.first().waitFor();
    check("every point is drawn", (await points.count()) === 4, await points.count());
    check("the title is text", (await page.title()) === "A page </script><b>that is shown</b>", await page.title());
    check("no text of the study becomes a script", await page.evaluate(() => typeof wrong === "undefined"));
    check("the picture of the chart is there too", (await page.locator("figure svg").count()) === 1);

    const told = page.locator("#told");
    check("nothing is told before the pointer is on a point", !(await told.isVisible()));
    await points.first().hover();
    const text = await told.innerText();
    for (const part of ["plain </script>", "family: fine", "C: 0.2", "/viscosity/alpha: 0", '"type":"symplectic_euler"', "relative L2 error: ", "CPU time [s]: "])
        check(`the pointer tells ${part}`, text.includes(part), text);
    await page.mouse.move(2, 2);

    const families = page.locator("#families label");
    check("a family's name is text", (await families.nth(1).innerText()).includes("<i>coarse</i>"));
    const marks = await page.locator("#families .mark").evaluateAll((all) => all.map((mark) => mark.textContent + mark.style.color));
    check("each family has a mark of its own in the legend", new Set(marks).size === 2 && marks.every((mark) => mark[0] !== "r"), marks.join(" "));
    await families.nth(0).click();
    await page.waitForFunction(() => document.querySelectorAll("#chart svg .mark-symbol path").length === 2);
    await points.first().hover();
    check("a box of the legend hides its family and no other", (await told.innerText()).includes("form: thick"));
    await families.nth(1).click();
    await page.waitForFunction(() => document.querySelector("#chart").textContent === "No point is shown.");
    for (const family of [0, 1]) await families.nth(family).click();
    await page.waitForFunction(() => document.querySelectorAll("#chart svg .mark-symbol path").length === 4);

    await page.locator("#norm").selectOption("errors.max");
    await page.waitForFunction(() => document.querySelector("#chart svg").textContent.includes("largest error [Pa]"));
    check("another norm is drawn", (await points.count()) === 4);
    check("nothing is written to the console", troubles.console.length === 0, troubles.console.join("; "));
    check("nothing is asked of a network", troubles.requests.length === 0, troubles.requests.join(" "));
    await page.emulateMedia({ media: "print" });
    check("on paper there are charts and tables without controls", !(await page.locator("#norm").isVisible()) && (await page.locator("table").last().isVisible()));
}

async function main() {
    const flags = ["--no-sandbox", "--disable-gpu", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync"];
    const browser = await playwright.chromium.launch({ executablePath: chromium, headless: true, args: flags });
    try {
        const page = await browser.newPage();
        page.setDefaultTimeout(20000);
        const troubles = { console: [], requests: [] };
        page.on("console", (message) => troubles.console.push(message.text()));
        page.on("pageerror", (error) => troubles.console.push(String(error)));
        page.on("request", (request) => request.url() !== `file://${page_file}` && troubles.requests.push(request.url().slice(0, 80)));
        await page.goto(`file://${page_file}`);
        await look(page, troubles);
    } finally {
        await browser.close();
    }
}

main().then(() => process.exit(failures ? 1 : 0), (error) => {
    console.log("FAILED ", error);
    process.exit(1);
});
